// What a study with several cells per job wants: cells, keys, and what runs in any case.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "runner/plan/plan.hpp"
#include "runner/study/ladder.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

std::string with(const std::string& numerics, const std::string& rest = "") {
  return study_text({}, "[numerics]\n" + numerics + "\n" + rest);
}
std::vector<double> cells_of(const std::vector<Job>& jobs) {
  std::vector<double> cells;
  for (const Job& job : jobs) cells.push_back(job.scene.numerics.cell_size);
  return cells;
}

TEST(Ladder, CellsAreAFactorOfRootTwoAndTwoRungsExactlyTwo) {
  for (int k = -5; k < 5; ++k) {
    EXPECT_EQ(finer_cell(0.1e-6, k + 2), finer_cell(0.1e-6, k) / 2) << k;
    EXPECT_NEAR(finer_cell(0.1e-6, k) / finer_cell(0.1e-6, k + 1), rung_ratio(), 1e-12) << k;
    EXPECT_EQ(finer_cell(0.2e-6, k), finer_cell(0.1e-6, k - 2)) << "a coarser ladder has the same cells";
  }
  EXPECT_EQ(finer_cell(0.1e-6, 0), 0.1e-6);
}

TEST(Ladder, IsUnderTheCellThatIsGiven) {
  const Plan plan = make_plan(read_text(with("cell_size = \"0.1 um\"\nladder = 4")));
  ASSERT_EQ(plan.jobs.size(), 1u);
  ASSERT_EQ(plan.ladders.size(), 1u);
  EXPECT_EQ(plan.jobs[0].scene.numerics.cell_size, 0.1e-6);
  EXPECT_FALSE(plan.jobs[0].rung_of);
  EXPECT_EQ(cells_of(plan.ladders[0]),
            (std::vector{finer_cell(0.1e-6, -3), 0.2e-6, finer_cell(0.1e-6, -1), 0.1e-6}));
  EXPECT_EQ(plan.ladders[0].back().key, plan.jobs[0].key);
  EXPECT_EQ(plan.ladders[0][0].rung_of, 0);
  EXPECT_EQ(first_jobs(plan).size(), 4u);
  EXPECT_EQ(all_jobs(plan).size(), 4u);
  // The job is the one of a study without a ladder, and a ladder does not enter keys.
  EXPECT_EQ(make_plan(read_text(with("cell_size = \"0.1 um\""))).jobs[0].key, plan.jobs[0].key);
  EXPECT_EQ(make_plan(read_text(with("cell_size = \"0.2 um\""))).jobs[0].key, plan.ladders[0][1].key);
}

TEST(Ladder, WithoutACellStartsAtTheRadius) {
  const Plan plan = make_plan(read_text(with("ladder = 5")));
  EXPECT_EQ(plan.ladders[0][0].scene.numerics.cell_size, 1.5e-6 / 4);
  EXPECT_EQ(plan.jobs[0].scene.numerics.cell_size, 1.5e-6 / 16);
  // A longer one adds finer cells.
  const Plan longer = make_plan(read_text(with("ladder = 6")));
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(longer.ladders[0][k].key, plan.ladders[0][k].key);
}

TEST(Ladder, AnAccuracyRunsFourCellsAndMayRunMore) {
  const Study study = read_text(with("accuracy = \"1 %\""));
  EXPECT_EQ(study.ladder.accuracy, 0.01);
  EXPECT_EQ(study.ladder.quantity, "collapsibility");
  const Plan plan = make_plan(study);
  EXPECT_EQ(first_jobs(plan).size(), static_cast<std::size_t>(first_cells));
  EXPECT_EQ(all_jobs(plan).size(), static_cast<std::size_t>(default_most_cells));
  EXPECT_EQ(plan.jobs[0].key, plan.ladders[0][first_cells - 1].key);
  EXPECT_LT(cpu_seconds(first_jobs(plan)), cpu_seconds(all_jobs(plan)) / 10);
  EXPECT_EQ(make_plan(read_text(with("ladder = 4"))).jobs[0].key, plan.jobs[0].key);
  EXPECT_EQ(read_text(with("accuracy = 0.01\naccuracy_of = \"aspect_ratio\"")).ladder.quantity,
            "aspect_ratio");
}

TEST(Ladder, OnlyWhatCanBeTheFinestWritesSnapshots) {
  const std::string measure = "[measure]\nsnapshots = [\"1 ns\"]\n";
  const auto fixed = make_plan(read_text(with("cell_size = \"0.1 um\"\nladder = 3", measure))).ladders[0];
  EXPECT_TRUE(fixed[0].scene.measures.snapshots.empty());
  EXPECT_TRUE(fixed[1].scene.measures.snapshots.empty());
  EXPECT_EQ(fixed[2].scene.measures.snapshots.size(), 1u);
  const auto climbing = make_plan(read_text(with("accuracy = 0.01", measure))).ladders[0];
  EXPECT_TRUE(climbing[2].scene.measures.snapshots.empty());
  EXPECT_EQ(climbing[3].scene.measures.snapshots.size(), 1u);
  EXPECT_EQ(climbing[6].scene.measures.snapshots.size(), 1u);
}

TEST(Ladder, SweptCellsShareRungs) {
  const Plan plan =
      make_plan(read_text(with("cell_size = { values = [0.2, 0.1], unit = \"um\" }\nladder = 3")));
  EXPECT_EQ(plan.jobs.size(), 2u);
  EXPECT_EQ(first_jobs(plan).size(), 5u);  // 0.4 0.283 0.2 0.141 0.1: the 0.2 is a job of its own
  EXPECT_FALSE(first_jobs(plan)[0].rung_of);
}

TEST(Ladder, SetGivesACellOrAnAccuracy) {
  ReadOptions options;
  options.set = {{"accuracy", "\"1 %\""}};
  EXPECT_TRUE(read_text(with("cell_size = \"0.1 um\""), options).ladder.accuracy);
  options.set = {{"cell_size", "\"0.1 um\""}};
  EXPECT_FALSE(read_text(with("accuracy = 0.01"), options).ladder.accuracy);
}

TEST(Ladder, EveryKindOfSceneHasOne) {
  for (const auto kind :
       {mpm::SceneKind::cavity_impact, mpm::SceneKind::planar_impact, mpm::SceneKind::imploding_shell})
    EXPECT_FALSE(default_accuracy_of(kind).empty());
  EXPECT_EQ(problems_of("schema = 1\nname = \"shell\"\nscene = \"imploding-shell\"\n[parameters]\n"
                        "material = \"aluminium\"\ninner_radius = \"1.5 um\"\nouter_radius = \"3 um\"\n"
                        "inner_speed = \"300 m/s\"\nend_time = \"6 ns\"\n[numerics]\naccuracy = \"1 %\"\n"),
            "");
  EXPECT_EQ(problems_of("schema = 1\nname = \"planar\"\nscene = \"planar-impact\"\n[parameters]\n"
                        "material = \"aluminium\"\nimpact_speed = \"200 m/s\"\nblock_width = \"1.6 um\"\n"
                        "block_height = \"20 um\"\nend_time = \"6 ns\"\n[numerics]\naccuracy = \"1 %\"\n"),
            "");
}

}  // namespace
}  // namespace mpmstudy
