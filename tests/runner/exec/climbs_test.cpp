// Ladders against a real catalog, with a simulation whose collapse is of first order in the cell: how high
// they climb, that nothing is run twice, and what the catalog then says.
#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <mutex>
#include <set>
#include <thread>

#include "runner/catalog/query.hpp"
#include "runner/exec/run_studies.hpp"
#include "runner/ladder/intervals.hpp"
#include "runner/study/ladder.hpp"
#include "tests/runner/fakes.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

class Ladders : public testing::Test {
 protected:
  /// 0.5 - 0.1 cell/um.
  mpm::RunResult collapse(const mpm::Scene& s) {
    {
      std::lock_guard lock(mutex);
      EXPECT_TRUE(ran.insert(job_key(s)).second) << "run twice";
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    mpm::RunResult result = fakes::result_of(s);
    if (s.numerics.cell_size == broken_cell) {
      result.status = mpm::RunStatus::failed;
      result.reason = "density left its range";
    }
    result.collapsibility = 0.5 - s.numerics.cell_size / 10e-6;
    result.collapsibility_error = measuring_error;
    result.final_area = *result.initial_area * (1 - *result.collapsibility);
    return result;
  }
  RunReport run(const Study& study, unsigned workers = 2) {
    CatalogWriter writer(folder.path());
    Status status;
    const Simulate simulate = [this](const mpm::Scene& s, mpm::Observer&) { return collapse(s); };
    ExecutorOptions options;
    options.results = folder.path();
    options.workers = workers;
    options.budget_s = budget;
    const std::vector<PlannedStudy> planned = {{make_plan(study), study.title}};
    const RunReport report =
        run_studies(planned, false, writer, status, simulate, fakes::write_snapshot, flag, options);
    writer.replace_intervals(study.name, intervals_of(study, folder.path()));
    return report;
  }
  static Study study(const std::string& numerics) {
    return read_text(
        study_text({{"cavity_radius", "[\"1 um\", \"2 um\"]"}}, "[numerics]\n" + numerics + "\n"));
  }
  std::vector<std::vector<SqlValue>> ask(const std::string& sql) { return query(folder.path(), sql).rows; }
  double number(const std::string& sql) { return std::get<double>(ask(sql).at(0).at(0)); }
  std::int64_t whole(const std::string& sql) { return std::get<std::int64_t>(ask(sql).at(0).at(0)); }

  fakes::TemporaryFolder folder;
  StopFlag flag;
  std::mutex mutex;
  std::set<std::string> ran;  // guarded by mutex
  double broken_cell = 0, measuring_error = 0;
  double seconds = 0, budget = 0;  ///< of a run of the simulation; of the whole
};

TEST_F(Ladders, AFixedOneRunsItsCellsAndHasIntervals) {
  const RunReport report = run(study("cell_size = \"0.1 um\"\nladder = 3"));
  EXPECT_EQ(report.exit_code(), 0);
  EXPECT_EQ(ran.size(), 6u);
  // The study has its own two jobs; coarser cells are there without it.
  EXPECT_EQ(whole("SELECT count(*) FROM jobs WHERE study = 'test'"), 2);
  EXPECT_EQ(whole("SELECT count(*) FROM jobs WHERE study IS NULL"), 4);
  EXPECT_EQ(whole("SELECT count(*) FROM ladders WHERE study = 'test' AND quantity = 'collapsibility'"), 6);
  EXPECT_EQ(whole("SELECT count(DISTINCT key) FROM ladders WHERE study = 'test'"), 2);
  // 0.5 - 0.1 h [um]: at 0.1 um 0.49, at cell 0 0.5
  EXPECT_NEAR(number("SELECT collapsibility FROM jobs WHERE study = 'test'"), 0.49, 1e-12);
  EXPECT_NEAR(number("SELECT collapsibility_error FROM jobs WHERE study = 'test'"), 0.015, 1e-12);
  EXPECT_NEAR(number("SELECT extrapolated_value FROM accuracy WHERE quantity = 'collapsibility'"), 0.5,
              1e-12);
  EXPECT_NEAR(number("SELECT extrapolated_error FROM accuracy WHERE quantity = 'collapsibility'"), 0.005,
              1e-12);
  EXPECT_NEAR(number("SELECT observed_order FROM accuracy WHERE quantity = 'collapsibility'"), 1, 1e-9);
  EXPECT_EQ(whole("SELECT count(*) FROM accuracy WHERE reached IS NOT NULL"), 0);
  // The error of a metric is its interval, that of the area goes with the collapse.
  EXPECT_EQ(
      number("SELECT error FROM metrics JOIN jobs USING (key) WHERE name = 'roundness' AND study = 'test'"),
      number("SELECT error FROM accuracy WHERE quantity = 'roundness'"));
  EXPECT_NEAR(number("SELECT final_area_error_m2 / initial_area_m2 FROM jobs WHERE study = 'test'"), 0.0152,
              1e-4);
  run(study("cell_size = \"0.1 um\"\nladder = 3"));
  EXPECT_EQ(ran.size(), 6u);
}

TEST_F(Ladders, TheCatalogKeepsWhyAFinerCellWasAskedFor) {
  run(study("accuracy = \"1 %\""));
  const auto reasons = ask("SELECT DISTINCT substr(reason, 1, 39) FROM decisions ORDER BY 1");
  ASSERT_EQ(reasons.size(), 3u);
  EXPECT_EQ(reasons[0][0], SqlValue("a coarser cell, for the interval"));
  EXPECT_EQ(reasons[1][0], SqlValue("a finer cell: collapsibility is known t"));
  EXPECT_EQ(reasons[2][0], SqlValue("a point of the sweep"));
}

// The budget is that of the run, not of each of its rounds.
TEST_F(Ladders, ABudgetIsThatOfAllRounds) {
  seconds = 0.2;
  budget = 0.3;  // the first round takes at least 0.2 s
  const RunReport report = run(study("accuracy = \"0.1 %\""), 64);
  EXPECT_TRUE(report.executed.budget_spent);
  EXPECT_GT(report.left(), 0);
}

TEST_F(Ladders, AnAccuracyClimbsAsFarAsItMust) {
  // The half width over 0.5 is 0.1 h/um: 0.88 % at the fourth cell of R = 1 um, at the sixth of R = 2 um.
  EXPECT_EQ(run(study("accuracy = \"1 %\"")).exit_code(), 0);
  EXPECT_EQ(ran.size(), 4u + 6u);
}

TEST_F(Ladders, TheFinestCellIsTheStudysJob) {
  run(study("accuracy = \"1 %\""));
  const auto rows =
      ask("SELECT cavity_radius_m / cell_size_m, position FROM jobs WHERE study = 'test' ORDER BY position");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(std::get<double>(rows[0][0]), 8 * rung_ratio(), 1e-9);
  EXPECT_EQ(whole("SELECT count(*) FROM accuracy WHERE reached = 1"), 2);
  EXPECT_LE(number("SELECT max(extrapolated_error / wanted_error) FROM accuracy WHERE wanted_error > 0"), 1);
}

TEST_F(Ladders, ResumeAndGoHigherWithoutRunningAnythingTwice) {
  run(study("accuracy = \"1 %\""));
  const auto before = ran.size();
  const RunReport again = run(study("accuracy = \"1 %\""));
  EXPECT_EQ(ran.size(), before);
  EXPECT_EQ(again.executed.done, 0);
  EXPECT_EQ(static_cast<std::size_t>(again.reused), before);
  run(study("accuracy = \"0.7 %\""));  // collapse() fails the test where a key comes again
  EXPECT_GT(ran.size(), before);
  EXPECT_EQ(whole("SELECT count(*) FROM jobs WHERE study = 'test'"), 2);
}

TEST_F(Ladders, DoNotDependOnWorkers) {
  const std::string wanted = "SELECT * FROM accuracy ORDER BY key, quantity";
  run(study("accuracy = \"0.5 %\""), 1);
  const auto alone = ask(wanted);
  const auto keys = ran;
  ran.clear();
  std::filesystem::remove_all(folder.path() / "catalog.db");
  for (const char* end : {"-wal", "-shm"})
    std::filesystem::remove(folder.path() / (std::string("catalog.db") + end));
  run(study("accuracy = \"0.5 %\""), 3);
  EXPECT_EQ(ran, keys);
  EXPECT_EQ(ask(wanted), alone);
}

TEST_F(Ladders, ALimitThatIsReachedIsSaid) {
  const RunReport report = run(study("accuracy = \"0.1 %\"\nladder = 5"));
  EXPECT_EQ(ran.size(), 10u);
  EXPECT_EQ(report.exit_code(), 0) << "every job is decided: finishing the study says that it was missed";
  EXPECT_EQ(whole("SELECT count(*) FROM accuracy WHERE reached = 0"), 2);
}

TEST_F(Ladders, NoCellsAreSpentOnAMeasuringError) {
  measuring_error = 0.1;
  run(study("accuracy = \"1 %\""));
  EXPECT_EQ(ran.size(), 8u);
  EXPECT_EQ(whole("SELECT count(*) FROM accuracy WHERE reached = 0"), 2);
  EXPECT_GE(number("SELECT min(extrapolated_error) FROM accuracy WHERE reached = 0"), 0.1);
}

TEST_F(Ladders, AFailedCoarseCellIsLeftOut) {
  broken_cell = finer_cell(0.1e-6, -2);
  const RunReport report = run(study("cell_size = \"0.1 um\"\nladder = 4"));
  EXPECT_EQ(report.exit_code(), 1);
  EXPECT_EQ(whole("SELECT max(cells) FROM accuracy WHERE quantity = 'collapsibility'"), 3);
  EXPECT_EQ(whole("SELECT count(*) FROM ladders WHERE status = 'failed' AND quantity IS NULL"), 2);
}

TEST_F(Ladders, OneCellHasNoInterval) {
  measuring_error = 0.02;
  run(study("cell_size = \"0.1 um\""));
  EXPECT_TRUE(ask("SELECT * FROM accuracy").empty());
  EXPECT_EQ(number("SELECT collapsibility_error FROM jobs"), 0.02);
}

}  // namespace
}  // namespace mpmstudy
