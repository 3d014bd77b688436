// The executor against a ledger in memory: order, failures, stops.
#include "runner/exec/executor.hpp"

#include <gmock/gmock.h>

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "tests/runner/exec/executor.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

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
