#pragma once
/// An executor whose jobs are recorded in memory.
#include <gmock/gmock.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "runner/exec/executor.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {

class MemoryLedger : public Ledger {
 public:
  JobReservation reserve(const std::string& key) override {
    std::lock_guard lock(mutex);
    if (refuse == key) return {false, refusals-- > 0 ? JobStatus::running : JobStatus::done};
    reserved.push_back(key);
    return {true, JobStatus::running, crashes[key]};
  }
  std::int64_t crashed(const std::string& key) override {
    std::lock_guard lock(mutex);
    return ++crashes[key];
  }
  bool complete(FinishedJob job) override {
    std::lock_guard lock(mutex);
    if (disk_full) throw std::runtime_error("disk full");
    if (taken_up == job.key) return false;
    finished[job.key] = std::move(job);
    return true;
  }
  bool lost(const std::string& key) const override { return taken_up == key; }
  bool holds(const std::string& key) override { return taken_up != key; }
  void release(const std::string& key, const std::string&) override {
    std::lock_guard lock(mutex);
    released.push_back(key);
  }
  void flush() override {}

  std::mutex mutex;
  std::string refuse, taken_up;  // keys
  int refusals = 0;              // for which another process runs it; then it has decided it
  std::map<std::string, std::int64_t> crashes;
  bool disk_full = false;
  std::vector<std::string> reserved, released;
  std::map<std::string, FinishedJob> finished;
};

class ExecutorTest : public testing::Test {
 protected:
  ExecutorReport run(std::vector<Job> jobs, const Simulate& simulate, unsigned workers = 1,
                     const WriteSnapshot& write = fakes::write_snapshot) {
    options.results = folder.path();
    options.workers = workers;
    options.look_again_s = 0.01;
    return execute_jobs(std::move(jobs), simulate, write, ledger, status, flag, options);
  }
  static mpm::RunResult fake(const mpm::Scene& s, mpm::Observer& o) { return fakes::simulate(s, o); }
  fakes::TemporaryFolder folder;
  MemoryLedger ledger;
  Status status;
  StopFlag flag;
  ExecutorOptions options;
};

}  // namespace mpmstudy
