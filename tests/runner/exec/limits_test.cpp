// Jobs that run over their time or memory, that crash or hang, and runs whose time is over.
#include <gmock/gmock.h>

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "tests/runner/exec/executor.hpp"
#include "tests/sanitized.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

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
  ASSERT_EQ(own.result.histories.size(), 1u) << "the gauges of the scene reach that process";
  EXPECT_EQ(own.result.histories[0].name, "rear");
  EXPECT_EQ(own.result.histories[0].unit, "m/s");
  EXPECT_EQ(own.result.histories[0].times, expected.histories[0].times);
  EXPECT_EQ(own.result.histories[0].values, expected.histories[0].values);
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

}  // namespace
}  // namespace mpmstudy
