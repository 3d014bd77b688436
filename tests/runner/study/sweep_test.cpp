#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> radii(const Study& study) {
  std::vector<double> values;
  for (const mpm::Scene& scene : study.scenes) values.push_back(scene.cavity_radius);
  return values;
}

TEST(Sweep, Spellings) {
  const std::vector<double> expected = {1e-6, 1.5e-6};
  for (const char* text :
       {"[\"1 um\", \"1.5 um\"]", "[\"1e-3 mm\", \"1500 nm\"]", "{ values = [1.0, 1.5], unit = \"um\" }",
        "{ values = [1, 1.5], unit = \"um\" }", "{ from = 1, to = 1.5, count = 2, unit = \"um\" }"})
    EXPECT_EQ(radii(read_text(study_text({{"cavity_radius", text}}))), expected) << text;
}

TEST(Sweep, LinearPointsAreReadableDecimals) {
  const Study study =
      read_text(study_text({{"cavity_radius", "{ from = 0.2, to = 0.5, count = 4, unit = \"um\" }"}}));
  EXPECT_THAT(radii(study), ElementsAre(0.2e-6, 0.3e-6, 0.4e-6, 0.5e-6));
}

TEST(Sweep, Logarithmic) {
  const Study study = read_text(study_text(
      {{"cavity_radius", "{ from = 0.25, to = 2, count = 4, unit = \"um\", spacing = \"log\" }"}}));
  EXPECT_THAT(radii(study), ElementsAre(0.25e-6, 0.5e-6, 1e-6, 2e-6));
}

TEST(Sweep, GridVariesTheLastAxisFastest) {
  const Study study = read_text(study_text({{"impact_speed", "[\"100 m/s\", \"200 m/s\"]"},
                                            {"cavity_radius", "[\"1 um\", \"1.5 um\", \"2 um\"]"}}));
  EXPECT_THAT(study.swept, ElementsAre("impact_speed", "cavity_radius"));
  EXPECT_THAT(radii(study), ElementsAre(1e-6, 1.5e-6, 2e-6, 1e-6, 1.5e-6, 2e-6));
  ASSERT_EQ(study.scenes.size(), 6u);
  EXPECT_EQ(study.scenes[2].impact_speed, 100);
  EXPECT_EQ(study.scenes[3].impact_speed, 200);
}

TEST(Sweep, ChoicesPureNumbersAndTheCellToo) {
  const Study study = read_text(
      study_text({},
                 "[numerics]\ncell_size = [\"0.1 um\", \"0.2 um\"]\nscheme = [\"gimp\", \"bspline2\"]\n"
                 "particles_per_cell = { values = [1, 4, 9] }\n[material]\nkinematic_fraction = [0, 0.5]\n"));
  EXPECT_EQ(study.scenes.size(), 24u);
  EXPECT_THAT(study.swept, ElementsAre("cell_size", "scheme", "particles_per_cell", "kinematic_fraction"));
  EXPECT_EQ(study.scenes.back().numerics.scheme, mpm::ShapeFunction::bspline2);
  EXPECT_EQ(study.scenes.back().numerics.particles_per_cell, 9);
  EXPECT_EQ(study.scenes.back().material.kinematic_fraction, 0.5);
}

TEST(Sweep, ZipPairsValues) {
  const Study study = read_text(study_text(
      {{"impact_speed", "[\"100 m/s\", \"200 m/s\"]"}, {"cavity_radius", "[\"1 um\", \"1.5 um\"]"}},
      "[sweep]\nmode = \"zip\"\n"));
  ASSERT_EQ(study.scenes.size(), 2u);
  EXPECT_EQ(study.scenes[1].impact_speed, 200);
  EXPECT_EQ(study.scenes[1].cavity_radius, 1.5e-6);
}

std::string sampled(const std::string& mode, int samples, int seed = 1) {
  return study_text({{"impact_speed", "{ from = 100, to = 200, unit = \"m/s\" }"},
                     {"cavity_radius", "{ from = 0.5, to = 2, unit = \"um\", spacing = \"log\" }"}},
                    "[sweep]\nmode = \"" + mode + "\"\nsamples = " + std::to_string(samples) +
                        "\nseed = " + std::to_string(seed) + "\n");
}

TEST(Sweep, RandomIsDeterministicAndExtensible) {
  const Study small = read_text(sampled("random", 5)), large = read_text(sampled("random", 8));
  ASSERT_EQ(small.scenes.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(small.scenes[i].impact_speed, large.scenes[i].impact_speed);
    EXPECT_GE(small.scenes[i].cavity_radius, 0.5e-6);
    EXPECT_LE(small.scenes[i].cavity_radius, 2e-6);
  }
  EXPECT_NE(radii(small), radii(read_text(sampled("random", 5, 2))));
  EXPECT_EQ(small.scenes[0].impact_speed, 156.656157517);  // the same on every machine
}

TEST(Sweep, LatinHypercubeFillsTheRange) {
  const Study study = read_text(sampled("latin-hypercube", 20));
  std::set<int> strata;
  for (const mpm::Scene& scene : study.scenes)
    strata.insert(static_cast<int>((scene.impact_speed - 100) / 5));
  EXPECT_EQ(strata.size(), 20u);
}

TEST(Sweep, CountsBeforeItExpands) {
  const std::string huge =
      study_text({{"impact_speed", "{ from = 1, to = 2, count = 4000000000, unit = \"m/s\" }"},
                  {"cavity_radius", "{ from = 1, to = 2, count = 4000000000, unit = \"um\" }"}});
  EXPECT_THAT(problems_of(huge), HasSubstr("jobs = 16000000000000000000: more than 1000000 jobs"));
  EXPECT_THAT(problems_of(huge), HasSubstr("--yes"));
  const std::string three = study_text({{"cavity_radius", "[\"1 um\", \"1.5 um\", \"2 um\"]"}});
  ReadOptions options;
  options.most_jobs = 2;
  EXPECT_THAT(problems_of(three, options), HasSubstr("jobs = 3: more than 2 jobs"));
  options.most_jobs = 3;
  EXPECT_EQ(problems_of(three, options), "");
}

}  // namespace
}  // namespace mpmstudy
