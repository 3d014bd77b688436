// What a search may look for and over what, how its results are stored, what it ends with, and what is
// forecast.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <mutex>
#include <sstream>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/finish/figures.hpp"
#include "runner/finish/fits.hpp"
#include "runner/search/forecast.hpp"
#include "tests/runner/search/search_study.hpp"

namespace mpmstudy {
namespace {

/// `text` with something else in place of a line that begins so.
std::string with(std::string study, const std::string& begin, const std::string& line) {
  const auto at = study.find("\n" + begin) + 1;
  return study.replace(at, study.find('\n', at) - at, line);
}

constexpr const char* yield_text = R"(schema = 1
name = "firm"
scene = "cavity-impact"
[parameters]
material = "aluminium"
block_width = "10 um"
block_height = "11 um"
cavity_radius = ["1 um", "1.5 um"]
wall_thickness = "2 um"
impact_speed = ["400 m/s", "500 m/s", "700 m/s"]
end_time = "16 ns"
[numerics]
cell_size = "0.4 um"
[search]
critical = "yield_stress"
outcome = "arrested"
between = ["10 MPa", "3 GPa"]
tolerance = "10 MPa"
[[fit]]
x = "impact_speed"
y = "critical_yield_stress"
model = "linear"
[[figure]]
name = "firm"
kind = "xy"
x = "impact_speed"
y = "critical_yield_stress"
)";

double critical_yield(const mpm::Scene& s) { return 1e6 * s.impact_speed * s.cavity_radius * 1e6; }

// Trial 4: pascals were filed, fitted and drawn as m/s.
TEST_F(SearchStudy, OfAYieldStressIsFiledFittedAndDrawnInPascals) {
  study_text = yield_text;
  outcome = [](const mpm::Scene& s) {
    return s.material.yield_stress >= critical_yield(s) ? "arrested" : "ejected";
  };
  EXPECT_EQ(search(folder.path(), 2).exit_code(), 0);
  const auto found = query(folder.path(),
                           "SELECT quantity, unit, lower, upper, swept ->> 'cavity_radius_m', swept ->> "
                           "'impact_speed_m_s', swept FROM brackets WHERE study = 'firm' ORDER BY position");
  ASSERT_EQ(found.rows.size(), 6u);
  for (const auto& row : found.rows) {
    EXPECT_EQ(row[0], SqlValue("yield_stress"));
    EXPECT_EQ(row[1], SqlValue("Pa"));
    const double critical = 1e6 * std::get<double>(row[5]) * std::get<double>(row[4]) * 1e6;
    EXPECT_LT(std::get<double>(row[2]), critical);
    EXPECT_GE(std::get<double>(row[3]), critical * (1 - 1e-12));
  }
  EXPECT_EQ(found.rows[0][6], SqlValue(R"({"cavity_radius_m":1e-06,"impact_speed_m_s":400.0})"));
  EXPECT_TRUE(query(folder.path(), "SELECT * FROM critical_speed").rows.empty()) << "they are no speeds";

  const Study study = read_text(study_text);
  const StudyResults results = read_results(study, folder.path());
  EXPECT_EQ(results.missing, 0u);
  const Fits fits = fit_study(study, results);
  EXPECT_TRUE(fits.not_made.empty());
  ASSERT_EQ(fits.rows.size(), 4u) << "a line for each radius";
  EXPECT_EQ(fits.rows[1].quantity, "critical_yield_stress");
  EXPECT_EQ(fits.rows[1].unit, "Pa/(m/s)");
  EXPECT_NEAR(fits.rows[1].value, 1e6, 0.04e6);
  EXPECT_NEAR(fits.rows[3].value, 1.5e6, 0.04e6);
  draw_figures(study, results);
  std::ifstream svg(folder.path() / "figures" / study.name / "firm.svg");
  std::stringstream drawn;
  drawn << svg.rdbuf();
  EXPECT_THAT(drawn.str(), testing::HasSubstr("Critical yield stress"));
  EXPECT_THAT(drawn.str(), testing::HasSubstr("GPa"));
}

// Trial 12: the values of a search gave 1.2999999999999998e-06, a length that is made of others
// 4.000000000000001e-06.
TEST_F(SearchStudy, WhatIsComputedIsFoundAsItWouldBeWritten) {
  study_text = with(with(search_text, "cavity_radius", "impact_speed = \"500 m/s\""), "wall_thickness",
                    "cavity_center_height = \"5 um\"");
  study_text = with(with(study_text, "critical", "critical = \"cavity_radius\""), "between",
                    "between = [\"1 um\", \"2 um\"]");
  study_text = with(with(study_text, "tolerance", "tolerance = \"0.1 um\""), "cell_size",
                    "cell_size = [\"0.4 um\", \"0.2 um\"]");
  outcome = [](const mpm::Scene& s) { return s.cavity_radius > 1.25e-6 ? "ejected" : "arrested"; };
  EXPECT_EQ(search(folder.path(), 2).exit_code(), 0);
  const auto number = [&](const std::string& sql) {
    return std::get<std::int64_t>(query(folder.path(), "SELECT count(*) FROM " + sql).rows[0][0]);
  };
  EXPECT_EQ(number("brackets WHERE lower = 1.2e-6 AND upper = 1.3e-6"), 2);
  EXPECT_EQ(number("jobs WHERE cavity_radius_m = 1.3e-6"), 2);
  EXPECT_EQ(number("job WHERE exact ->> 'cavity_radius_m' = 1.2999999999999998e-06"), 2) << "as it is keyed";
  EXPECT_EQ(read_results(read_text(study_text), folder.path()).done.size(), 2u);
  for (const StoredJob& stored : read_jobs(folder.path()))
    EXPECT_EQ(job_key(stored.job.scene), stored.job.key);
}

// The file gives the wall, so the centre moves with the radius that is searched.
TEST_F(SearchStudy, AWallThatTheFileGivesStaysWhateverIsSearched) {
  study_text = with(with(search_text, "cavity_radius", "impact_speed = \"500 m/s\""), "wall_thickness",
                    "wall_thickness = \"1 um\"");
  study_text = with(with(study_text, "critical", "critical = \"cavity_radius\""), "between",
                    "between = [\"1 um\", \"2 um\"]");
  study_text = with(with(study_text, "tolerance", "tolerance = \"0.1 um\""), "cell_size",
                    "cell_size = [\"0.4 um\", \"0.2 um\"]");
  outcome = [](const mpm::Scene& s) { return s.cavity_radius > 1.25e-6 ? "ejected" : "arrested"; };
  EXPECT_EQ(search(folder.path(), 2).exit_code(), 0);
  const auto rows =
      query(folder.path(), "SELECT DISTINCT wall_thickness_m, count(DISTINCT cavity_radius_m) > 2 FROM jobs");
  ASSERT_EQ(rows.rows.size(), 1u);
  EXPECT_EQ(rows.rows[0][0], SqlValue(1e-6));
  EXPECT_EQ(rows.rows[0][1], SqlValue(std::int64_t{1}));
  EXPECT_EQ(read_results(read_text(study_text), folder.path()).done.size(), 2u);
}

TEST_F(SearchStudy, AHeightThatIsMadeOfAWallIsFoundAsItWouldBeWritten) {
  study_text = with(with(search_text, "cavity_radius", "cavity_radius = \"1 um\""), "block_height",
                    "block_height = \"6 um\"");
  study_text = with(with(study_text, "wall_thickness", "wall_thickness = [\"1 um\", \"2 um\"]"), "cell_size",
                    "cell_size = \"0.4 um\"");
  search(folder.path(), 2);
  const auto rows =
      query(folder.path(),
            "SELECT DISTINCT j.exact ->> 'cavity_center_height_m' FROM job j JOIN jobs USING (key) "
            "WHERE jobs.cavity_center_height_m = 4e-6 AND jobs.wall_thickness_m = 1e-6");
  ASSERT_EQ(rows.rows.size(), 1u);
  EXPECT_EQ(rows.rows[0][0], SqlValue(4.000000000000001e-06));
  EXPECT_EQ(read_results(read_text(study_text), folder.path()).done.size(), 2u);
}

TEST_F(SearchStudy, BracketsOfAnEarlierFormOfTheStudyAreNotItsOwn) {
  search(folder.path(), 2);
  Study study = read_text(study_text);
  EXPECT_EQ(read_results(study, folder.path()).done.size(), 15u);
  study_text =
      with(search_text, "wall_thickness", "wall_thickness = { values = [0.6, 1, 2, 3, 4], unit = \"um\" }");
  const StudyResults results = read_results(read_text(study_text), folder.path());
  EXPECT_EQ(results.done.size(), 12u);
  EXPECT_EQ(results.missing, 3u);
}

// Trial 10: exit code 0 and no row.
TEST_F(SearchStudy, WhatIsNotFoundHasARowAndAnExitCode) {
  study_text = with(search_text, "between", "between = [\"600 m/s\", \"1000 m/s\"]");
  for (int run = 0; run < 2; ++run) {
    const SearchOutcome report = search(folder.path(), 2);
    EXPECT_EQ(report.exit_code(), 1) << run;
    EXPECT_GT(report.not_found(), 0);
    simulated.clear();
  }
  const auto rows = query(folder.path(),
                          "SELECT flags, count(*), count(lower), count(upper), count(lower_key), "
                          "count(extrapolated) FROM brackets GROUP BY flags ORDER BY flags DESC");
  ASSERT_EQ(rows.rows.size(), 3u);
  EXPECT_EQ(rows.rows[0][0], SqlValue("no upper end"));
  EXPECT_EQ(rows.rows[1][0], SqlValue("no lower end"));
  for (int i = 0; i < 2; ++i)
    for (int k = 2; k < 6; ++k) EXPECT_EQ(rows.rows[i][k], SqlValue(std::int64_t(0)));
  EXPECT_EQ(query(folder.path(), "SELECT * FROM critical_speed").rows.size(), 15u);
  const StudyResults results = read_results(read_text(study_text), folder.path());
  EXPECT_EQ(results.missing, 0u) << "looked for and not found is not missing";
  EXPECT_EQ(results.done.size(), 15u - static_cast<std::size_t>(std::get<std::int64_t>(rows.rows[0][1]) +
                                                                std::get<std::int64_t>(rows.rows[1][1])));
}

// Trial 10: 1 the first time, 0 again.
TEST_F(SearchStudy, FailedJobsHaveTheSameExitCodeEveryTime) {
  breaks = [](const mpm::Scene& s) { return s.impact_speed > 1500; };
  const SearchOutcome first = search(folder.path(), 2);
  EXPECT_EQ(first.exit_code(), 1);
  EXPECT_EQ(first.run.left_failed, 0);
  const SearchOutcome again = search(folder.path(), 2);
  EXPECT_EQ(again.exit_code(), 1);
  EXPECT_EQ(again.run.executed.failed, 0);
  EXPECT_EQ(again.run.left_failed, first.run.executed.failed);
  EXPECT_EQ(again.run.reused, first.run.executed.done);
}

// Trial 9: rounds of jobs that are all done went on.
TEST_F(SearchStudy, AfterASignalNoRoundBegins) {
  stop_at = 20;
  search(folder.path(), 2);
  const std::size_t before = simulated.size();
  const SearchOutcome stopped = search(folder.path(), 2);  // the signal is still there
  EXPECT_EQ(simulated.size(), before);
  EXPECT_GT(stopped.run.left(), 0);
  EXPECT_EQ(stopped.exit_code(), 75);
  EXPECT_TRUE(stopped.brackets.empty());
}

// Another run may plan a job again that this one's next round waits for.
TEST_F(SearchStudy, ThatAnotherRunTakesAJobAwayLeavesWork) {
  breaks = [this](const mpm::Scene&) {
    std::lock_guard lock(mutex);
    if (simulated.size() == 3)
      open_for_writing(folder.path())->exec("UPDATE job SET status = 'planned' WHERE status = 'done'");
    return false;
  };
  const SearchOutcome report = search(folder.path(), 1);
  EXPECT_GT(report.run.left(), 0);
  EXPECT_EQ(report.exit_code(), 75);
  EXPECT_TRUE(report.brackets.empty());
}

TEST_F(SearchStudy, TheBudgetIsThatOfAllRounds) {
  ExecutorOptions executor;
  executor.budget_s = 1e-6;
  const SearchOutcome report = search(folder.path(), 1, 0, executor);
  EXPECT_EQ(report.exit_code(), 75);
  EXPECT_TRUE(report.run.executed.budget_spent);
}

TEST_F(SearchStudy, AValueThatTheSweepHasTwiceIsSearchedOnce) {
  study_text = with(search_text, "wall_thickness", "wall_thickness = [\"1 um\", \"2 um\", \"1 um\"]");
  EXPECT_EQ(search(folder.path(), 2).brackets.size(), 6u);
  const StudyResults results = read_results(read_text(study_text), folder.path());
  EXPECT_EQ(results.done.size(), 6u);
  EXPECT_EQ(results.missing, 0u);
  for (const JobResults& job : results.done)
    EXPECT_TRUE(!job.extrapolated || std::isfinite(job.extrapolated->value));
}

TEST_F(SearchStudy, ALadderOfCellsIsASweepOfThemAndGivesAnInterval) {
  study_text = with(search_text, "cell_size", "cell_size = \"0.1 um\"\nladder = 3");
  EXPECT_EQ(search(folder.path(), 2).exit_code(), 0);
  const auto rows = query(folder.path(),
                          "SELECT count(*), count(DISTINCT cell_size_m), count(interval), max(cell_size_m) / "
                          "min(cell_size_m) FROM brackets");
  EXPECT_EQ(rows.rows[0][0], SqlValue(std::int64_t(15)));
  EXPECT_EQ(rows.rows[0][1], SqlValue(std::int64_t(3)));
  EXPECT_EQ(rows.rows[0][2], SqlValue(std::int64_t(5)));
  EXPECT_NEAR(std::get<double>(rows.rows[0][3]), 2, 1e-12);
}

TEST_F(SearchStudy, AForecastIsNearWhatRunsAndKnowsWhatHasRun) {
  const Study study = read_text(study_text);
  const SearchForecast before = forecast(study);
  search(folder.path(), 2);
  const int ran = static_cast<int>(simulated.size());
  EXPECT_LE(before.fewest, before.runs);
  EXPECT_GE(before.most, before.runs);
  EXPECT_NEAR(before.runs, ran, 0.3 * ran);
  const SearchForecast after = forecast(study);
  EXPECT_EQ(after.most, 0);
  EXPECT_TRUE(after.rounds.empty());
}

TEST_F(SearchStudy, AForecastOfAFinerCellGoesByTheCoarserOnes) {
  study_text = with(search_text, "cell_size", "cell_size = { values = [0.4, 0.2], unit = \"um\" }");
  search(folder.path(), 2);
  study_text = search_text;
  const SearchForecast expected = forecast(read_text(study_text));
  simulated.clear();
  search(folder.path(), 2);
  const int ran = static_cast<int>(simulated.size());
  EXPECT_GT(ran, 5);
  EXPECT_NEAR(expected.runs, ran, 0.5 * ran);
  EXPECT_LE(expected.most, 2 * ran);
}

// What `explain` prints is what was written down when the job was asked for.
TEST_F(SearchStudy, TheCatalogKeepsWhyAJobWasAskedFor) {
  search(folder.path(), 2);
  const auto reasons = query(folder.path(),
                             "SELECT d.reason, j.wall_thickness_m, j.impact_speed_m_s FROM decisions d JOIN "
                             "jobs j USING (key, study) WHERE d.study = 'critical' ORDER BY d.position")
                           .rows;
  ASSERT_EQ(reasons.size(), simulated.size());
  const auto reason = [&](std::size_t i) { return std::get<std::string>(reasons[i][0]); };
  EXPECT_EQ(reason(0), "round 1 of the search: the first values, over the whole range");
  EXPECT_THAT(
      reason(reasons.size() - 1),
      testing::MatchesRegex("round [0-9]+ of the search: the critical value lies between [0-9.]+ k?m/s and "
                            "[0-9.]+ k?m/s"));
  EXPECT_TRUE(query(folder.path(), "SELECT key FROM decisions WHERE reason IS NULL").rows.empty());
}

}  // namespace
}  // namespace mpmstudy
