// What a valid study is told before it runs.
#include "runner/plan/warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "runner/plan/resources.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> warnings(const std::string& text, const ReadOptions& options = {}) {
  const Study study = read_text(text, options);
  return warnings_of(study, make_plan(study));
}

TEST(Warnings, AGoodStudyHasNone) { EXPECT_THAT(warnings(study_text()), IsEmpty()); }

/// Some of the paper's walls are thin for their coarsest cells. Nothing else may be said of the studies.
TEST(Warnings, StudiesOfTheProjectHaveThoseThatAreMeant) {
  for (const char* folder : {"paper", "examples"})
    for (const auto& file :
         std::filesystem::directory_iterator(std::string(SOURCE_DIR "/studies/") + folder)) {
      if (file.path().extension() != ".toml") continue;
      const Study study = read_study(file.path());
      const auto said = warnings_of(study, make_plan(study));
      if (study.name == "two-body-jet")  // ends at 5 ns, waits for what has struck the far wall
        EXPECT_THAT(said, ElementsAre(HasSubstr("hold together"))) << file.path();
      else
        EXPECT_THAT(said, testing::Each(HasSubstr("cells thick"))) << file.path();
    }
}

TEST(Warnings, AValueWithoutAnEffect) {
  EXPECT_THAT(warnings(study_text({}, "[material]\nspall_strength = \"1 GPa\"\n")),
              ElementsAre(AllOf(HasSubstr(".toml:15:18: spall_strength: has no effect"),
                                HasSubstr("needs tension = \"cutoff\""))));
  EXPECT_THAT(warnings(study_text({}, "[material]\nspall_strength = \"1 GPa\"\ntension = \"cutoff\"\n")),
              IsEmpty());
  EXPECT_THAT(warnings(study_text({}, "[measure]\ndetached_for = \"1 ns\"\nstop = \"decided\"\n")),
              ElementsAre(HasSubstr("detached_for: has no effect"), HasSubstr("stop: has no effect")));
  EXPECT_THAT(
      warnings(study_text({}, "[material]\nkinematic_fraction = 0.5\nhardening_modulus = \"0 Pa\"\n")),
      ElementsAre(HasSubstr("kinematic_fraction: has no effect")));
}

TEST(Warnings, SweptValuesThatAreTheSameRun) {
  const Study study =
      read_text(study_text({}, "[material]\nspall_strength = [\"0 Pa\", \"1 GPa\", \"2 GPa\"]\n"));
  const Plan plan = make_plan(study);
  EXPECT_EQ(plan.jobs.size(), 1u);
  EXPECT_THAT(
      warnings_of(study, plan),
      testing::Contains(HasSubstr(
          "2 combinations are the same run as another one: values of spall_strength have no effect")));
  EXPECT_THAT(warnings(study_text({{"cavity_radius", "[\"1 um\", \"1000 nm\"]"}})),
              ElementsAre(HasSubstr("1 combination is the same run as another one: a value is given twice")));
}

TEST(Warnings, PartsThatTheGridDoesNotShow) {
  const std::string thin =
      study_text({{"cavity_center_height", "\"4.43 um\""}}, "[numerics]\ncell_size = \"0.14 um\"\n");
  EXPECT_THAT(
      warnings(thin),
      ElementsAre(AllOf(HasSubstr("the wall above the cavity is 0.5 cells thick (70 nm at a cell of 140 nm)"),
                        HasSubstr(".toml:10:24: wall_thickness"))));
  EXPECT_THAT(warnings(study_text({{"cavity_center_height", "\"1.6 um\""}})),
              ElementsAre(HasSubstr("the wall below the cavity is 1 cells thick (100 nm at")));
  EXPECT_THAT(warnings(study_text({{"block_width", "\"3.1 um\""}})),
              ElementsAre(HasSubstr("between the cavity and its mirror image is 1 cells thick (100 nm")));
  // Two cells are enough.
  EXPECT_THAT(warnings(study_text({{"cavity_center_height", "\"1.7 um\""}})), IsEmpty());
  // Of a ladder, the coarsest counts: 0.2 um of 0.1 * sqrt(2)^3.
  EXPECT_THAT(warnings(study_text({{"cavity_center_height", "\"1.7 um\""}},
                                  "[numerics]\ncell_size = \"0.1 um\"\nladder = 4\n")),
              ElementsAre(AllOf(HasSubstr("0.71 cells"), HasSubstr(", the ladder's coarsest"))));
  // Of many jobs: how many, and the worst of them.
  EXPECT_THAT(warnings(study_text({{"cavity_center_height", "[\"1.6 um\", \"1.65 um\", \"1.8 um\"]"}})),
              ElementsAre(HasSubstr(": 2 of 3 jobs: the wall below the cavity is 1 cells thick (100 nm at")));
}

std::string two_bodies(const std::string& end_time) {
  std::string text = study_text({{"impact_speed", "\"5 m/s\""}, {"end_time", "\"" + end_time + "\""}});
  return text.replace(text.find("cavity-impact"), 13, "two-body-impact");
}

TEST(Warnings, BodiesThatHoldTogether) {
  // 6 um at 5.4 km/s and back at 6.4 km/s: 2.1 ns.
  EXPECT_THAT(warnings(two_bodies("1.9 ns")), IsEmpty());
  EXPECT_THAT(
      warnings(two_bodies("16 ns")),
      ElementsAre(AllOf(HasSubstr("end_time: 16 ns is later than about 2.0"), HasSubstr("hold together"))));
}

TEST(Warnings, PrefixesThatAreUnusual) {
  EXPECT_THAT(warnings(study_text({{"yield_stress", "\"120 mPa\""}})),
              ElementsAre(AllOf(HasSubstr("yield_stress: 120 mPa is unusual"), HasSubstr("M is mega"))));
  EXPECT_THAT(warnings(study_text({{"yield_stress", "\"infinite\""}})), IsEmpty());
  EXPECT_THAT(warnings(study_text({{"yield_stress", "\"0 Pa\""}})), IsEmpty());
  EXPECT_THAT(warnings(study_text({}, "[material]\nreference_density = \"2.7 kg/m3\"\n")),
              ElementsAre(HasSubstr("reference_density: 2.7 kg/m3 is unusual")));
}

TEST(Warnings, ShocksBeyondTheEquationOfState) {
  EXPECT_THAT(warnings(study_text({{"impact_speed", "\"9 km/s\""}})),
              ElementsAre(HasSubstr("valid to pressure_limit = 270 GPa")));
}

TEST(Warnings, WindowsOfGaugesWithoutASample) {
  const std::string gauge = R"(
[[gauge]]
name = "push"
of = "force"
wall = "bottom"
reduce = { short = "mean 1 ns to 1.02 ns", long = "mean 1 ns to 2 ns", then = "at 1 ns" }
)";
  EXPECT_THAT(warnings(study_text({}, gauge)),
              ElementsAre(AllOf(HasSubstr("push.short is of 20 ps, and samples are 50 ps apart"),
                                HasSubstr(":15:"))));
  EXPECT_THAT(warnings(study_text({}, "[measure]\narea_every = \"0.02 ns\"\n" + gauge)), IsEmpty());
}

TEST(Warnings, AScaleOfCellsThatAreNotGiven) {
  ReadOptions options;
  options.cells = 2;
  EXPECT_THAT(warnings(study_text({}, "[numerics]\naccuracy = \"1 %\"\n"), options),
              ElementsAre(HasSubstr("--cells has no effect")));
  EXPECT_THAT(warnings(study_text(), options), IsEmpty());
  const std::string searched = study_text({},
                                          "[numerics]\n[search]\ncritical = \"cell_size\"\noutcome = "
                                          "\"collapsed\"\nbetween = [\"0.1 um\", \"0.4 um\"]\n"
                                          "tolerance = \"0.1 um\"\n");
  EXPECT_THAT(warnings(searched, options),
              ElementsAre(HasSubstr("--cells has no effect: cell_size is looked")));
}

TEST(Resources, GrowWithParticlesAndWorkers) {
  const Plan plan = make_plan(read_text(study_text({{"cavity_radius", "[\"1 um\", \"2 um\"]"}})));
  const double one = predicted_bytes(plan.jobs[0].scene, plan.jobs[0].estimate);
  const double other = predicted_bytes(plan.jobs[1].scene, plan.jobs[1].estimate);
  EXPECT_GT(one, other);  // a smaller cavity has more around it
  const double program = demand_of({}, 1).bytes;
  EXPECT_DOUBLE_EQ(demand_of(plan.jobs, 1).bytes, program + one);
  EXPECT_DOUBLE_EQ(demand_of(plan.jobs, 2).bytes, program + one + other);
  EXPECT_DOUBLE_EQ(demand_of(plan.jobs, 64).bytes, program + one + other);
  mpm::Scene scene = plan.jobs[0].scene;
  scene.numerics.precision = mpm::Precision::single_precision;
  EXPECT_LT(predicted_bytes(scene, plan.jobs[0].estimate), one);
}

}  // namespace
}  // namespace mpmstudy
