// A search against a real catalog and a fake simulation whose critical speed is known: the same brackets for
// any number of workers and after a stop, no speed twice, searches that begin from neighbours and coarser
// cells, and the audit.
#include "runner/exec/run_studies.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "runner/catalog/query.hpp"
#include "tests/runner/search/search_study.hpp"

namespace mpmstudy {
namespace {

TEST_F(SearchStudy, BracketsHoldTheCriticalSpeedAndNameTheirProofs) {
  const SearchOutcome report = search(folder.path(), 2);
  EXPECT_EQ(report.run.exit_code(), 0);
  ASSERT_EQ(report.brackets.size(), 15u);
  int finest = 0;
  for (const FoundBracket& b : report.brackets) {
    ASSERT_TRUE(b.lower) << b.flags;
    EXPECT_LE(*b.lower, critical_speed(b.point.scene));
    EXPECT_GT(*b.upper, critical_speed(b.point.scene));
    EXPECT_LE(*b.upper - *b.lower, 10);
    EXPECT_EQ(b.flags, "");
    if (b.point.cell < 0.15e-6) finest += b.runs;
  }
  EXPECT_LE(finest, 5 * 6) << "at most six runs per point on the finest cell, on average";
  const auto proofs =
      query(folder.path(),
            "SELECT l.outcome, u.outcome, l.impact_speed_m_s = c.lower_m_s, u.impact_speed_m_s = "
            "c.upper_m_s, l.wall_thickness_m = c.wall_thickness_m FROM critical_speed c JOIN jobs l ON "
            "l.key = c.lower_key JOIN jobs u ON u.key = c.upper_key");
  ASSERT_EQ(proofs.rows.size(), 15u);
  for (const auto& row : proofs.rows)
    EXPECT_EQ(row, (std::vector<SqlValue>{"arrested", "ejected", std::int64_t(1), std::int64_t(1),
                                          std::int64_t(1)}));
}

// A round lasts as long as its longest run: runs of one cell share it.
TEST_F(SearchStudy, AFinerCellWaitsForTheCoarserOneOfAllPoints) {
  search(folder.path(), 1);
  EXPECT_TRUE(std::ranges::is_sorted(cells, std::greater<>()));
  EXPECT_EQ(std::set<double>(cells.begin(), cells.end()).size(), 3u);
}

TEST_F(SearchStudy, ExtrapolatesToCellsOfSizeZero) {
  search(folder.path(), 2);
  const auto found =
      query(folder.path(),
            "SELECT wall_thickness_m, extrapolated_m_s, interval_m_s FROM critical_speed WHERE "
            "extrapolated_m_s IS NOT NULL ORDER BY 1");
  ASSERT_EQ(found.rows.size(), 5u);
  for (const auto& row : found.rows) {
    const double d = std::get<double>(row[0]) * 1e6;
    EXPECT_NEAR(std::get<double>(row[1]), 203 + 250 * d + 30 * d * d, std::get<double>(row[2]));
  }
}

TEST_F(SearchStudy, IsTheSameForAnyNumberOfWorkersAndAfterAStop) {
  search(folder.path() / "one", 1);
  simulated.clear();
  search(folder.path() / "three", 3);
  EXPECT_EQ(rows(folder.path() / "one"), rows(folder.path() / "three"));

  simulated.clear();
  stop_at = 11;
  const SearchOutcome stopped = search(folder.path() / "stopped", 2);
  EXPECT_GT(stopped.run.left(), 0);
  EXPECT_EQ(rows(folder.path() / "stopped").find("critical,"), std::string::npos)
      << "no brackets before the end";
  flag.clear();
  stop_at = -1;
  // What was running when the stop came is run again.
  const auto done = query(folder.path() / "stopped", "SELECT key FROM jobs WHERE status = 'done'");
  simulated.clear();
  for (const auto& row : done.rows) simulated.insert(std::get<std::string>(row[0]));
  EXPECT_EQ(search(folder.path() / "stopped", 2).run.left(), 0);
  EXPECT_EQ(rows(folder.path() / "stopped"), rows(folder.path() / "one"));
}

// Every round registers the jobs of those before it, too: what fails now is not tried in all rounds after it.
TEST_F(SearchStudy, AFailedJobIsTriedAgainOncePerRun) {
  breaks = [](const mpm::Scene& s) { return s.impact_speed > 900 && s.impact_speed < 1100; };
  const SearchOutcome first = search(folder.path(), 2);
  EXPECT_GT(first.run.executed.failed, 1);
  simulated.clear();  // search() refuses a key that it has seen
  retry_failed = true;
  const SearchOutcome again = search(folder.path(), 2);
  EXPECT_EQ(again.run.executed.failed, first.run.executed.failed);
  EXPECT_EQ(again.run.executed.done, 0);
}

TEST_F(SearchStudy, WhereRunsFailHalfStepsKeepTheToleranceAndAuditsLeaveThemOut) {
  breaks = [](const mpm::Scene& s) {
    const double off = std::abs(std::remainder(s.impact_speed, 10));
    return off < 1e-6 && std::abs(s.impact_speed - critical_speed(s)) < 5;
  };
  const SearchOutcome report = search(folder.path(), 2, 1);
  EXPECT_GT(report.run.executed.failed, 0u);
  EXPECT_EQ(report.audit.audited, report.audit.early);
  const auto in_vain =
      query(folder.path(), "SELECT key FROM jobs WHERE study LIKE '%-audit' AND status = 'failed'");
  EXPECT_TRUE(in_vain.rows.empty());
  int narrowed = 0;
  for (const FoundBracket& b : report.brackets) {
    ASSERT_TRUE(b.lower && b.upper);
    EXPECT_LE(*b.upper - *b.lower, 10 + 1e-6);
    const double critical = critical_speed(b.point.scene);
    EXPECT_LE(*b.lower, critical);
    EXPECT_GE(*b.upper, critical);
    EXPECT_FALSE(b.lower_key.empty() || b.upper_key.empty());
    narrowed += b.flags.find("failed at") != std::string::npos && std::abs(std::remainder(*b.lower, 10)) > 1;
  }
  EXPECT_GT(narrowed, 0);
}

TEST_F(SearchStudy, RunningAgainRunsNothing) {
  search(folder.path(), 2);
  const auto before = simulated.size();
  search(folder.path(), 2);
  EXPECT_EQ(simulated.size(), before);
}

TEST_F(SearchStudy, AnAuditRunsASampleToTheEndAndNamesFalseStops) {
  const SearchOutcome honest = search(folder.path() / "honest", 2, 0.3);
  EXPECT_GT(honest.audit.audited, 0);
  EXPECT_LT(honest.audit.audited, honest.audit.early);
  EXPECT_TRUE(honest.audit.disagreeing.empty());
  simulated.clear();
  late = true;
  const SearchOutcome wrong = search(folder.path() / "wrong", 2, 1);
  EXPECT_EQ(wrong.audit.audited, wrong.audit.early);
  EXPECT_GT(wrong.audit.disagreeing.size(), 0u);
  // Audited runs are no runs of the study.
  const auto other = query(folder.path() / "wrong",
                           "SELECT count(*) FROM jobs WHERE study = 'critical' AND stop = 'end-time'");
  EXPECT_EQ(other.rows[0][0], SqlValue(std::int64_t(0)));
}

}  // namespace
}  // namespace mpmstudy
