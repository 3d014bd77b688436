// The executor against a ledger in memory: order, failures, stops.
#include "runner/exec/executor.hpp"

#include <gmock/gmock.h>

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <map>
#include <mutex>
#include <thread>

#include "tests/runner/fakes.hpp"
#include "tests/sanitized.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

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

TEST_F(ExecutorTest, longest_first_and_equal_ones_in_order) {
  std::vector<Job> jobs = {fakes::job(1, 2), fakes::job(2, 9), fakes::job(3, 2), fakes::job(4, 5)};
  EXPECT_EQ(run(jobs, fake).done, 4);
  EXPECT_EQ(ledger.reserved, (std::vector{fakes::key(2), fakes::key(4), fakes::key(1), fakes::key(3)}));
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

TEST_F(ExecutorTest, threads_without_a_job_help_the_last_one) {
  std::atomic<bool> first_done{false}, helped{false};
  std::atomic<int> most_with_jobs_left{0};
  const auto simulate = [&](const mpm::Scene& scene, mpm::Observer& observer) {
    if (scene.cavity_radius == 1e-6) {  // job 1, the longest: ends only when all others are gone
      while (observer.threads() < 4) std::this_thread::yield();
      helped = first_done.load();
    } else {
      most_with_jobs_left = std::max(most_with_jobs_left.load(), observer.threads());
      first_done = true;
    }
    return fake(scene, observer);
  };
  std::vector<Job> jobs = {fakes::job(1, 9)};
  for (int n = 2; n <= 12; ++n) jobs.push_back(fakes::job(n, 1));
  EXPECT_EQ(run(jobs, simulate, 4).done, 12);
  EXPECT_TRUE(helped);
  EXPECT_LE(most_with_jobs_left, 2);  // 4 threads, at least two jobs
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
  EXPECT_THAT(ledger.finished.at(fakes::key(1)).reason, testing::HasSubstr("step 7: it broke"));
  EXPECT_EQ(ledger.finished.at(fakes::key(1)).failure, FailureKind::error);
  EXPECT_THAT(ledger.finished.at(fakes::key(2)).reason, testing::HasSubstr("out of memory"));
  EXPECT_EQ(ledger.finished.at(fakes::key(2)).failure, FailureKind::memory);
  EXPECT_EQ(ledger.finished.at(fakes::key(4)).failure, FailureKind::breakdown);
  EXPECT_EQ(ledger.finished.at(fakes::key(4)).reason, "energy error 3 %");
  EXPECT_EQ(ledger.finished.at(fakes::key(4)).result.area_history.size(), 50u);  // what it measured is kept
  EXPECT_EQ(report.left(), 0);
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
  ledger.refusals = 3;
  const auto report = run(fakes::plan(3).jobs, fake);  // waits until the other process has decided it
  EXPECT_EQ(ledger.refusals, -1);
  EXPECT_EQ(report.done_elsewhere, 1);
  EXPECT_EQ(report.done, 2);
  EXPECT_EQ(report.left(), 0);
}

TEST_F(ExecutorTest, a_result_that_is_refused_is_not_counted) {
  ledger.refusals = -1;  // whoever took it up has decided it
  const auto simulate = [&](const mpm::Scene& s, mpm::Observer& o) {
    if (s.cavity_radius == 1e-6 / 3) ledger.taken_up = fakes::key(3);  // meanwhile
    auto r = fakes::simulate(s, o);
    ledger.refuse = ledger.taken_up;
    return r;
  };
  const auto report = run(fakes::plan(3).jobs, simulate);
  EXPECT_EQ(report.done, 2);
  EXPECT_EQ(report.done_elsewhere, 1);
  EXPECT_EQ(report.left(), 0);
  EXPECT_FALSE(ledger.finished.contains(fakes::key(3)));
}

TEST_F(ExecutorTest, files_of_a_job_that_was_taken_up_are_left_to_the_one_that_has_it) {
  const auto simulate = [&](const mpm::Scene& s, mpm::Observer& o) {
    ledger.taken_up = ledger.refuse = fakes::key(1);
    ledger.refusals = -1;
    const auto theirs = folder.path() / "fields" / fakes::key(1) / "theirs";
    fs::create_directories(theirs.parent_path());
    std::ofstream(theirs) << "x";
    return fakes::simulate(s, o);
  };
  EXPECT_EQ(run({fakes::job(1)}, simulate).done_elsewhere, 1);
  EXPECT_TRUE(fs::exists(folder.path() / "fields" / fakes::key(1) / "theirs"));
  EXPECT_TRUE(ledger.released.empty());
}

TEST_F(ExecutorTest, a_stop_ends_the_wait_for_others) {
  ledger.refuse = fakes::key(1);
  ledger.refusals = 1 << 30;
  const auto simulate = [&](const mpm::Scene& s, mpm::Observer& o) {
    auto result = fakes::simulate(s, o);
    flag.ask(SIGTERM);
    return result;
  };
  EXPECT_EQ(run(fakes::plan(2).jobs, simulate).untouched, 1);
}

/// Job 2 fails as often as it is told.
struct FailsAtFirst {
  std::shared_ptr<std::atomic<int>> failures;
  mpm::RunResult operator()(const mpm::Scene& s, mpm::Observer& o) const {
    if (s.cavity_radius == 1e-6 / 2 && (*failures)-- > 0) throw std::runtime_error("unlucky");
    return fakes::simulate(s, o);
  }
};

TEST_F(ExecutorTest, retries_as_often_as_told) {
  options.retries = 2;
  const auto failures = std::make_shared<std::atomic<int>>(2);
  auto report = run(fakes::plan(3).jobs, FailsAtFirst{failures});
  EXPECT_EQ(report.done, 3);
  EXPECT_EQ(std::ranges::count(ledger.reserved, fakes::key(2)), 3);
  *failures = 3;
  report = run(fakes::plan(3).jobs, FailsAtFirst{failures});
  EXPECT_EQ(report.failed, 1);
}

/// Ten minutes of steps of a millisecond.
mpm::RunResult endless(const mpm::Scene& s, mpm::Observer& o) {
  for (int step = 1; step < 600'000; ++step) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (!o.on_step({step, 1e-12 * step, s.end_time, 1e-12, 1234})) {
      mpm::RunResult stopped;
      stopped.status = mpm::RunStatus::stopped;
      return stopped;
    }
  }
  return {};
}

TEST_F(ExecutorTest, a_job_that_runs_over_its_time_is_failed_where_it_was) {
  options.limits.seconds = 0.05;
  const auto report = run({fakes::job(1)}, endless);
  EXPECT_EQ(report.failed, 1);
  const auto& job = ledger.finished.at(fakes::key(1));
  EXPECT_EQ(job.failure, FailureKind::timeout);
  EXPECT_THAT(job.reason, testing::ContainsRegex("ran longer than 0.05 s \\(step [1-9]"));
  EXPECT_GT(job.result.steps, 0);
}

TEST_F(ExecutorTest, a_job_that_needs_too_much_memory_is_failed_and_the_rest_goes_on) {
  if (sanitized) GTEST_SKIP() << "a sanitizer ends the process where memory cannot be had";
  options.limits.memory = 64 << 20;
  const auto simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    if (s.cavity_radius == 1e-6 / 2) std::vector<char>(std::size_t{1} << 30).back() = 1;
    return fakes::simulate(s, o);
  };
  const auto report = run(fakes::plan(3).jobs, simulate, 2);
  EXPECT_EQ(report.done, 2);
  EXPECT_EQ(ledger.finished.at(fakes::key(2)).failure, FailureKind::memory);
  EXPECT_THAT(ledger.finished.at(fakes::key(2)).reason, testing::HasSubstr("more than 67.1089 MB"));
}

TEST_F(ExecutorTest, a_job_that_has_crashed_runs_in_a_process_of_its_own_with_the_same_result) {
  ledger.crashes[fakes::key(1)] = 1;
  const auto simulate = [me = getpid()](const mpm::Scene& s, mpm::Observer& o) {
    auto result = fakes::simulate(s, o);
    result.steps = getpid() == me;
    return result;
  };
  EXPECT_EQ(run(fakes::plan(2).jobs, simulate).done, 2);
  auto own = ledger.finished.at(fakes::key(1)), here = ledger.finished.at(fakes::key(2));
  EXPECT_EQ(own.result.steps, 0);
  EXPECT_EQ(here.result.steps, 1);
  const auto expected = fakes::result_of(fakes::scene(1e-6));
  EXPECT_EQ(own.result.energy_error, expected.energy_error);
  EXPECT_EQ(own.result.collapsibility, expected.collapsibility);
  ASSERT_EQ(own.result.area_history.size(), expected.area_history.size());
  EXPECT_EQ(own.result.area_history[7].void_area, expected.area_history[7].void_area);
  ASSERT_EQ(own.result.metrics.size(), 2u);
  EXPECT_EQ(own.result.metrics[0].name, "roundness");
  EXPECT_EQ(own.result.metrics[0].error, 0.1);
  ASSERT_EQ(own.snapshots.size(), 2u);
  EXPECT_EQ(checksum_of(folder.path() / own.snapshots[1].path), own.snapshots[1].checksum);
}

TEST_F(ExecutorTest, a_job_that_crashes_again_and_again_is_failed_and_the_rest_goes_on) {
  ledger.crashes[fakes::key(2)] = 1;
  const auto simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    if (s.cavity_radius == 1e-6 / 2) std::raise(SIGKILL);
    return fakes::simulate(s, o);
  };
  const auto report = run(fakes::plan(3).jobs, simulate, 2);
  EXPECT_EQ(report.done, 2);
  EXPECT_EQ(report.failed, 1);
  EXPECT_EQ(ledger.crashes[fakes::key(2)], 3);
  const auto& job = ledger.finished.at(fakes::key(2));
  EXPECT_EQ(job.failure, FailureKind::crash);
  EXPECT_THAT(job.reason, testing::HasSubstr("ended by signal 9 (Killed)"));
  EXPECT_THAT(job.reason, testing::EndsWith("crashes so far: 3, from 3 on the job is failed"));
}

TEST_F(ExecutorTest, a_process_of_a_job_that_hangs_is_killed) {
  ledger.crashes[fakes::key(1)] = 1;
  options.limits.seconds = 0.1;
  const auto hang = [](const mpm::Scene&, mpm::Observer&) -> mpm::RunResult {
    while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
  };
  EXPECT_EQ(run({fakes::job(1)}, hang).failed, 1);
  EXPECT_EQ(ledger.finished.at(fakes::key(1)).failure, FailureKind::timeout);
  // and a stop does not wait for it
  options.limits.seconds = 0;
  std::thread soon([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    flag.ask(SIGINT);
  });
  EXPECT_EQ(run({fakes::job(1)}, hang).stopped, 1);
  soon.join();
}

TEST_F(ExecutorTest, a_worker_that_does_not_let_go_is_abandoned_and_its_job_planned_again) {
  options.grace_s = 0.1;
  std::atomic<bool> abandoned = false;
  options.abandon = [&](const ExecutorReport& report) {
    EXPECT_EQ(report.stopped, 1);
    EXPECT_EQ(ledger.released, std::vector{fakes::key(1)});
    abandoned = true;
  };
  const auto deaf = [&](const mpm::Scene& s, mpm::Observer& o) {
    flag.ask(SIGINT);
    while (!abandoned) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return fakes::simulate(s, o);
  };
  run({fakes::job(1)}, deaf);
  EXPECT_TRUE(abandoned);
}

TEST_F(ExecutorTest, the_time_for_which_the_process_was_stopped_is_not_the_jobs) {
  const SignalGuard signals;
  options.limits.seconds = 0.4;
  const auto simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    const pid_t me = getpid();
    if (fork() == 0) {
      usleep(600'000);
      kill(me, SIGCONT);
      _exit(0);
    }
    o.on_step({0, 0, s.end_time, 0, 1});
    raise(SIGSTOP);
    return fakes::simulate(s, o);
  };
  const auto report = run({fakes::job(1)}, simulate);
  EXPECT_EQ(report.done, 1);
  EXPECT_EQ(report.failed, 0);
}

TEST_F(ExecutorTest, a_spent_budget_starts_no_more_jobs) {
  options.budget_s = 0.02;
  const auto slow = [](const mpm::Scene& s, mpm::Observer& o) {
    return fakes::simulate(s, o, std::chrono::milliseconds(5));
  };
  const auto report = run(fakes::plan(5).jobs, slow);
  EXPECT_EQ(report.done, 1);
  EXPECT_EQ(report.untouched, 4);
  EXPECT_TRUE(report.budget_spent);
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
  const auto count = [&](unsigned workers, std::size_t jobs) {
    options.workers = workers;
    return worker_count(options, jobs);
  };
  EXPECT_EQ(count(8, 3), 3u);
  EXPECT_EQ(count(2, 3), 2u);
  EXPECT_EQ(count(2, 0), 1u);
  EXPECT_GE(count(0, 100), 1u);
  EXPECT_EQ(run({}, fake).done, 0);
}

TEST(Signals, the_first_asks) {
  const SignalGuard guard;
  EXPECT_FALSE(signal_flag().wanted());
  std::raise(SIGTERM);
  EXPECT_EQ(signal_flag().signal(), SIGTERM);
}

TEST(Signals, one_request_may_come_twice_and_the_kernel_repeats_its_own) {
  const SignalGuard guard;
  for (const int number : {SIGTERM, SIGTERM, SIGHUP}) std::raise(number);
  EXPECT_EQ(signal_flag().signal(), SIGTERM);
  usleep(600'000);
  std::raise(SIGXCPU);
  EXPECT_EQ(signal_flag().signal(), SIGTERM);
}

TEST(SignalsDeathTest, the_second_ends_at_once) {
  EXPECT_EXIT(
      {
        const SignalGuard guard;
        std::raise(SIGINT);
        usleep(600'000);
        std::raise(SIGINT);
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace mpmstudy
