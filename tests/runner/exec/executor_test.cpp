// The executor against a ledger in memory: order, failures, stops.
#include "runner/exec/executor.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <map>
#include <mutex>

#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

class MemoryLedger : public Ledger {
 public:
  bool claim(const std::string& key) override {
    std::lock_guard lock(mutex);
    if (refuse == key) return false;
    claimed.push_back(key);
    return true;
  }
  void finish(FinishedJob job) override {
    std::lock_guard lock(mutex);
    if (disk_full) throw std::runtime_error("disk full");
    finished[job.key] = std::move(job);
  }
  void release(const std::string& key, const std::string&) override {
    std::lock_guard lock(mutex);
    released.push_back(key);
  }
  void flush() override {}

  std::mutex mutex;
  std::string refuse;
  bool disk_full = false;
  std::vector<std::string> claimed, released;
  std::map<std::string, FinishedJob> finished;
};

class ExecutorTest : public testing::Test {
 protected:
  ExecutorReport run(std::vector<Job> jobs, const Simulate& simulate, unsigned workers = 1,
                     const WriteSnapshot& write = fakes::write_snapshot) {
    return execute_jobs(std::move(jobs), simulate, write, ledger, status, flag, {folder.path(), workers});
  }
  static mpm::RunResult fake(const mpm::Scene& s, mpm::Observer& o) { return fakes::simulate(s, o); }
  fakes::TemporaryFolder folder;
  MemoryLedger ledger;
  Status status;
  StopFlag flag;
};

TEST_F(ExecutorTest, longest_first_and_equal_ones_in_order) {
  std::vector<Job> jobs = {fakes::job(1, 2), fakes::job(2, 9), fakes::job(3, 2), fakes::job(4, 5)};
  EXPECT_EQ(run(jobs, fake).done, 4);
  EXPECT_EQ(ledger.claimed, (std::vector{fakes::key(2), fakes::key(4), fakes::key(1), fakes::key(3)}));
}

TEST_F(ExecutorTest, writes_snapshots_and_measures) {
  const auto report = run({fakes::job(1)}, fake);
  EXPECT_EQ(report.updates, 1234 * 100);
  const auto& job = ledger.finished.at(fakes::key(1));
  ASSERT_EQ(job.snapshots.size(), 2u);
  EXPECT_EQ(job.snapshots[0].path, "fields/" + fakes::key(1) + "/000_4.800ns.vtkhdf");
  EXPECT_EQ(job.snapshots[1].step, 6);
  for (const auto& file : job.snapshots) {
    EXPECT_EQ(static_cast<std::int64_t>(fs::file_size(folder.path() / file.path)), file.bytes);
    EXPECT_EQ(checksum_of(folder.path() / file.path), file.checksum);
    EXPECT_EQ(file.checksum.size(), 32u);
  }
  EXPECT_GE(job.wall_s, 0);
  EXPECT_GE(job.cpu_s, 0);
}

TEST_F(ExecutorTest, a_failing_job_does_not_stop_the_others) {
  const auto simulate = [](const mpm::Scene& s, mpm::Observer& o) -> mpm::RunResult {
    if (s.cavity_radius == 1e-6 / 1) throw std::runtime_error("step 7: it broke");
    if (s.cavity_radius == 1e-6 / 2) throw std::bad_alloc();
    if (s.cavity_radius == 1e-6 / 3) throw 5;
    auto r = fakes::simulate(s, o);
    if (s.cavity_radius == 1e-6 / 4) r.status = mpm::RunStatus::failed, r.reason = "energy error 3 %";
    return r;
  };
  const auto report = run(fakes::plan(6).jobs, simulate, 2);
  EXPECT_EQ(report.done, 2);
  EXPECT_EQ(report.failed, 4);
  EXPECT_EQ(ledger.finished.at(fakes::key(1)).reason, "step 7: it broke");
  EXPECT_EQ(ledger.finished.at(fakes::key(2)).reason, "out of memory");
  EXPECT_EQ(ledger.finished.at(fakes::key(4)).reason, "energy error 3 %");
  EXPECT_EQ(ledger.finished.at(fakes::key(4)).result.area_history.size(), 50u);  // what it measured is kept
  EXPECT_FALSE(report.work_left());
}

TEST_F(ExecutorTest, a_stop_lets_go_of_running_jobs) {
  const auto simulate = [&](const mpm::Scene& s, mpm::Observer& o) {
    if (s.cavity_radius == 1e-6 / 3) flag.ask(SIGINT);  // key 3 is second: longest first
    return fakes::simulate(s, o);
  };
  const auto report = run(fakes::plan(4).jobs, simulate);
  EXPECT_EQ(report.done, 1);
  EXPECT_EQ(report.stopped, 1);
  EXPECT_EQ(report.untouched, 2);
  EXPECT_EQ(ledger.released, std::vector{fakes::key(3)});
  EXPECT_FALSE(fs::exists(folder.path() / "fields" / fakes::key(3)));
}

TEST_F(ExecutorTest, a_disk_that_refuses_is_not_the_jobs_fault) {
  const auto write = [](const fs::path& path, const mpm::Snapshot&) {
    throw std::runtime_error(path.filename().string() + ": No space left on device");
  };
  const auto report = run(fakes::plan(3).jobs, fake, 1, write);
  EXPECT_EQ(report.failed, 0);
  EXPECT_EQ(report.stopped, 1);
  EXPECT_EQ(report.untouched, 2);
  EXPECT_THAT(report.storage_error, testing::HasSubstr("No space left"));
}

TEST_F(ExecutorTest, a_ledger_that_breaks_ends_the_run) {
  ledger.disk_full = true;
  EXPECT_THROW(run(fakes::plan(3).jobs, fake, 2), std::runtime_error);
}

TEST_F(ExecutorTest, jobs_of_others_are_left_alone) {
  ledger.refuse = fakes::key(2);
  const auto report = run(fakes::plan(3).jobs, fake);
  EXPECT_EQ(report.elsewhere, 1);
  EXPECT_EQ(report.done, 2);
  EXPECT_TRUE(report.work_left());
}

TEST_F(ExecutorTest, what_an_earlier_attempt_left_is_swept) {
  const auto old = folder.path() / "fields" / fakes::key(1) / "007_9.000ns.vtkhdf.tmp";
  fs::create_directories(old.parent_path());
  std::ofstream(old) << "half";
  run({fakes::job(1)}, fake);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(folder.path() / ledger.finished.at(fakes::key(1)).snapshots[0].path));
}

TEST_F(ExecutorTest, no_more_workers_than_jobs) {
  EXPECT_EQ(worker_count({"results", 8}, 3), 3u);
  EXPECT_EQ(worker_count({"results", 2}, 3), 2u);
  EXPECT_EQ(worker_count({"results", 2}, 0), 1u);
  EXPECT_GE(worker_count({"results", 0}, 100), 1u);
  EXPECT_EQ(run({}, fake).done, 0);
}

TEST(Signals, the_first_asks) {
  const SignalGuard guard;
  EXPECT_FALSE(signal_flag().wanted());
  std::raise(SIGTERM);
  EXPECT_EQ(signal_flag().signal(), SIGTERM);
}

TEST(SignalsDeathTest, the_second_ends_at_once) {
  EXPECT_EXIT(
      {
        const SignalGuard guard;
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace mpmstudy
