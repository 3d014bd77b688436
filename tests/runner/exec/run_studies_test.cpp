// Studies against a real catalog and a fake simulation: sharing, resuming, and the same rows for any number
// of workers.
#include "runner/exec/run_studies.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include "runner/catalog/query.hpp"
#include "tests/runner/fakes.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy {
namespace {

ExecutorOptions with(const std::filesystem::path& results, unsigned workers) {
  ExecutorOptions options;
  options.results = results;
  options.workers = workers;
  return options;
}

class RunStudies : public testing::Test {
 protected:
  RunReport run(const std::filesystem::path& results, std::vector<PlannedStudy> studies, unsigned workers = 2,
                bool retry_failed = false) {
    CatalogWriter writer(results);
    Status status;
    const Simulate simulate = [this](const mpm::Scene& s, mpm::Observer& o) {
      ++simulated;
      if (broken) throw std::runtime_error("broken");
      if (simulated == stop_at) flag.ask(stop_with);
      return fakes::simulate(s, o, pause);
    };
    return run_studies(studies, retry_failed, writer, status, simulate, fakes::write_snapshot, flag,
                       with(results, workers));
  }
  static PlannedStudy study(int jobs, const std::string& name = "fake") {
    return {fakes::plan(jobs, name), "A fake", {}};
  }
  fakes::TemporaryFolder folder;
  StopFlag flag;
  std::atomic<int> simulated = 0;
  std::atomic<bool> broken = false;
  int stop_at = -1, stop_with = SIGINT;
  std::chrono::milliseconds pause{0};
};

TEST_F(RunStudies, runs_once_and_reuses) {
  EXPECT_EQ(run(folder.path(), {study(5)}).exit_code(), 0);
  EXPECT_EQ(simulated, 5);
  const auto again = run(folder.path(), {study(5)});
  EXPECT_EQ(again.reused, 5);
  EXPECT_EQ(simulated, 5);
}

TEST_F(RunStudies, studies_share_jobs) {
  const auto report = run(folder.path(), {study(5, "a"), study(7, "b")});
  EXPECT_EQ(simulated, 7);
  EXPECT_EQ(report.executed.done, 7);
  EXPECT_EQ(run(folder.path(), {study(6, "c"), study(7, "a")}).reused, 7);
}

TEST_F(RunStudies, goes_on_after_a_stop) {
  stop_at = 3;
  const auto stopped = run(folder.path(), {study(8)}, 1);
  EXPECT_EQ(stopped.exit_code(), 130);
  EXPECT_EQ(stopped.executed.done, 2);
  EXPECT_EQ(stopped.left(), 6);
  EXPECT_EQ(std::get<std::int64_t>(
                query(folder.path(), "SELECT count(*) FROM jobs WHERE status = 'planned'").rows[0][0]),
            6);
  flag.clear();
  simulated = 0;
  stop_at = -1;
  const auto rest = run(folder.path(), {study(8)});
  EXPECT_EQ(rest.exit_code(), 0);
  EXPECT_EQ(rest.reused, 2);
  EXPECT_EQ(simulated, 6);
}

TEST_F(RunStudies, a_termination_ends_with_75) {
  stop_at = 1;
  stop_with = SIGTERM;
  EXPECT_EQ(run(folder.path(), {study(4)}).exit_code(), 75);
}

TEST_F(RunStudies, failures_end_with_1_and_are_retried_when_told) {
  broken = true;
  EXPECT_EQ(run(folder.path(), {study(3)}).exit_code(), 1);
  broken = false;
  const auto left = run(folder.path(), {study(3)});
  EXPECT_EQ(left.left_failed, 3);
  EXPECT_EQ(left.exit_code(), 1);
  EXPECT_EQ(simulated, 3);
  EXPECT_EQ(run(folder.path(), {study(3)}, 2, true).exit_code(), 0);
  EXPECT_EQ(simulated, 6);
}

TEST_F(RunStudies, rows_do_not_depend_on_workers_nor_on_stops) {
  run(folder.path() / "1", {study(12)}, 1);
  pause = std::chrono::milliseconds(1);
  run(folder.path() / "2", {study(12)}, 2);
  const auto expected = rows_of(folder.path() / "1");
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_EQ(rows_of(folder.path() / "2"), expected);
}

}  // namespace
}  // namespace mpmstudy
