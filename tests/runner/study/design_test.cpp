/// Designs of a sweep: sequences that fill a cube, distributions, groups that go together, requirements.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "runner/study/quasi_random.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

using Sequence = UnitSamples (*)(std::uint64_t, std::size_t, std::uint64_t);

class FillsTheCube : public testing::TestWithParam<Sequence> {};

TEST_P(FillsTheCube, ALargerSetBeginsWithASmallerOne) {
  for (const std::size_t axes : {1u, 2u, 7u, 40u}) {
    const auto small = GetParam()(37, axes, 3), large = GetParam()(74, axes, 3);
    for (std::size_t i = 0; i < small.size(); ++i) EXPECT_EQ(small[i], large[i]) << i << " of " << axes;
  }
  EXPECT_NE(GetParam()(4, 2, 3), GetParam()(4, 2, 4));
}

TEST_P(FillsTheCube, NoCoordinateIsOne) {
  for (const auto& point : GetParam()(500, 20, 1))
    for (const double coordinate : point) {
      EXPECT_GE(coordinate, 0);
      EXPECT_LT(coordinate, 1);
    }
}

/// The mean of the product of (1/2 + u_k) is 1. Independent points are off by about sqrt((13/12)^5 - 1) / 32
/// = 0.022.
TEST_P(FillsTheCube, IntegratesBetterThanRandomPoints) {
  const auto points = GetParam()(1024, 5, 11);
  double sum = 0;
  for (const auto& point : points) {
    double product = 1;
    for (const double u : point) product *= 0.5 + u;
    sum += product;
  }
  EXPECT_NEAR(sum / static_cast<double>(points.size()), 1, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Of, FillsTheCube, testing::Values(sobol_points, halton_points));

/// Of the first 2^m points, every one of 2^m strata of every axis has one, and every one of 2^m boxes of the
/// first two.
TEST(Sobol, IsANet) {
  constexpr int m = 6, n = 1 << m;
  const auto points = sobol_points(n, 12, 5);
  for (std::size_t axis = 0; axis < 12; ++axis) {
    std::set<int> strata;
    for (const auto& point : points) strata.insert(static_cast<int>(point[axis] * n));
    EXPECT_EQ(strata.size(), n) << axis;
  }
  for (int k = 0; k <= m; ++k) {
    std::set<std::pair<int, int>> boxes;
    for (const auto& point : points)
      boxes.insert({static_cast<int>(point[0] * (1 << k)), static_cast<int>(point[1] * (1 << (m - k)))});
    EXPECT_EQ(boxes.size(), n) << k;
  }
}

/// Of base^m points of axis k, every one of base^m strata has one.
TEST(Halton, HitsEveryStratumOfEveryBase) {
  const int bases[] = {2, 3, 5, 7, 11};
  for (std::size_t axis = 0; axis < 5; ++axis) {
    const int n = bases[axis] * bases[axis];
    std::set<int> strata;
    for (const auto& point : halton_points(static_cast<std::uint64_t>(n), 5, 9))
      strata.insert(static_cast<int>(point[axis] * n));
    EXPECT_EQ(strata.size(), static_cast<std::size_t>(n)) << axis;
  }
}

/// Digits of [Abramowitz, Stegun 1964, table 26.1] and their mirror.
TEST(NormalQuantile, IsThatOfTables) {
  EXPECT_EQ(normal_quantile(0.5), 0);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.841344746068543), 1, 1e-13);
  EXPECT_DOUBLE_EQ(normal_quantile(0.125), -normal_quantile(0.875));
  EXPECT_TRUE(std::isfinite(normal_quantile(0)));
  EXPECT_TRUE(std::isfinite(normal_quantile(1)));
}

std::string of_mode(const std::string& mode, int samples, const std::string& speed,
                    const std::string& rest = "") {
  return study_text(
      {{"impact_speed", speed}, {"cavity_radius", "{ from = 1, to = 2, unit = \"um\" }"}},
      "[sweep]\nmode = \"" + mode + "\"\nseed = 1\nsamples = " + std::to_string(samples) + "\n" + rest);
}

TEST(Design, ALargerSequenceKeepsTheJobsOfASmallerOne) {
  for (const char* mode : {"sobol", "halton", "random"}) {
    const std::string speed = "{ normal = [200, 10], unit = \"m/s\" }";
    const Study small = read_text(of_mode(mode, 16, speed)), large = read_text(of_mode(mode, 32, speed));
    ASSERT_EQ(large.scenes.size(), 32u);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(small.scenes[i].impact_speed, large.scenes[i].impact_speed) << mode;
      EXPECT_EQ(small.scenes[i].cavity_radius, large.scenes[i].cavity_radius) << mode;
    }
  }
}

/// The same on every machine; computed apart from the definitions, with the quantile of Python.
TEST(Design, KnownPoints) {
  const std::string speed = "{ normal = [0.2, 0.01], unit = \"km/s\" }";
  EXPECT_EQ(read_text(of_mode("sobol", 2, speed)).scenes[1].impact_speed, 184.981008274);
  EXPECT_EQ(read_text(of_mode("halton", 2, speed)).scenes[1].impact_speed, 197.241867547);
}

TEST(Design, DistributionsHaveTheirMoments) {
  constexpr int n = 1024;
  double mean = 0, square = 0;
  const Study normal = read_text(of_mode("sobol", n, "{ normal = [200, 10], unit = \"m/s\" }"));
  for (const mpm::Scene& scene : normal.scenes) mean += scene.impact_speed / n;
  for (const mpm::Scene& scene : normal.scenes) square += std::pow(scene.impact_speed - mean, 2) / n;
  EXPECT_NEAR(mean, 200, 0.1);
  EXPECT_NEAR(std::sqrt(square), 10, 0.2);
  const auto below = [&](const std::string& speed, double limit) {
    const Study study = read_text(of_mode("sobol", n, speed));
    return std::ranges::count_if(study.scenes, [&](const mpm::Scene& s) { return s.impact_speed < limit; });
  };
  EXPECT_NEAR(below("{ uniform = [100, 300], unit = \"m/s\" }", 150), n / 4, 2);
  EXPECT_NEAR(below("{ log_uniform = [100, 400], unit = \"m/s\" }", 200), n / 2, 2);
}

TEST(Design, UniformIsTheRangeOfItsEnds) {
  const Study range = read_text(of_mode("halton", 5, "{ from = 100, to = 300, unit = \"m/s\" }")),
              uniform = read_text(of_mode("halton", 5, "{ uniform = [100, 300], unit = \"m/s\" }"));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(range.scenes[i].impact_speed, uniform.scenes[i].impact_speed);
}

TEST(Design, WhatADistributionMakesOutOfRangeIsSaid) {
  const std::string speed = "{ normal = [10, 10], unit = \"m/s\" }";
  EXPECT_THAT(problems_of(of_mode("sobol", 64, speed)), HasSubstr("impact_speed = { normal = [10, 10]"));
  const Study study = read_text(of_mode("sobol", 64, speed, "invalid = \"skip\"\n"));
  ASSERT_EQ(study.skipped.size(), 1u);
  EXPECT_EQ(study.skipped[0].why, "impact_speed cannot be run");
  EXPECT_NEAR(static_cast<double>(study.skipped[0].points), 64 * 0.159, 3);
  EXPECT_EQ(study.scenes.size() + study.skipped[0].points, 64u);
}

TEST(Design, AGroupGoesTogetherInsideAGrid) {
  const Study study = read_text(study_text({{"impact_speed", "[\"100 m/s\", \"200 m/s\", \"300 m/s\"]"},
                                            {"yield_stress", "[\"60 MPa\", \"120 MPa\"]"},
                                            {"cavity_radius", "[\"1 um\", \"1.5 um\", \"2 um\"]"}},
                                           "[sweep]\nzip = [[\"impact_speed\", \"cavity_radius\"]]\n"));
  std::vector<std::pair<double, double>> found;
  std::vector<double> yields;
  for (const mpm::Scene& scene : study.scenes) {
    found.push_back({scene.impact_speed, scene.cavity_radius});
    yields.push_back(scene.material.yield_stress);
  }
  EXPECT_THAT(found, ElementsAre(Pair(100, 1e-6), Pair(100, 1e-6), Pair(200, 1.5e-6), Pair(200, 1.5e-6),
                                 Pair(300, 2e-6), Pair(300, 2e-6)));
  EXPECT_THAT(yields, ElementsAre(60e6, 120e6, 60e6, 120e6, 60e6, 120e6));
}

/// 0.7 um + 0.1 um is 7.999999999999999e-07 m.
TEST(Design, RequirementsCompareTo12Digits) {
  const auto jobs = [](const std::string& require) {
    return read_text(study_text({{"cavity_radius", "[\"0.7 um\", \"0.8 um\", \"0.9 um\"]"}},
                                "[sweep]\ninvalid = \"skip\"\nrequire = " + require + "\n"))
        .scenes.size();
  };
  EXPECT_EQ(jobs("\"cavity_radius > 0.7 um + 0.1 um\""), 1u);
  EXPECT_EQ(jobs("\"cavity_radius >= 0.7 um + 0.1 um\""), 2u);
  EXPECT_EQ(jobs("\"cavity_radius < 0.7 um + 0.1 um\""), 1u);
  EXPECT_EQ(jobs("\"cavity_radius == 0.7 um + 0.1 um\""), 1u);
  EXPECT_EQ(jobs("\"cavity_radius != 0.7 um + 0.1 um && cavity_radius > 0.75 um\""), 1u);
  EXPECT_EQ(jobs("[\"cavity_radius > 0.75 um\", \"cavity_radius < 0.85 um\"]"), 1u);
}

TEST(Design, SkippedPointsAreCountedByTheirReason) {
  const std::string text = study_text({{"cavity_radius", "[\"1 um\", \"2 um\", \"3.5 um\", \"4 um\"]"},
                                       {"cavity_center_height", "[\"3 um\", \"9.5 um\"]"},
                                       {"room", "\"0.2 um\""}},
                                      "[sweep]\nrequire = \"cavity_center_height > cavity_radius + room\"\n"
                                      "invalid = \"skip\"\n");
  const Study study = read_text(text);
  EXPECT_EQ(study.scenes.size(), 2u);
  ASSERT_EQ(study.skipped.size(), 2u);
  EXPECT_EQ(study.skipped[0].why, "cavity_center_height cannot be run");  // 9 um in a block of 6 um
  EXPECT_EQ(study.skipped[0].points, 4u);
  EXPECT_EQ(study.skipped[1].points, 2u);
  EXPECT_EQ(study.skipped[1].why, "require = \"cavity_center_height > cavity_radius + room\" does not hold");
  EXPECT_EQ(study.skipped[1].first, "cavity_center_height = 3 um, cavity_radius = 3.5 um, room = 0.2 um");
  std::string without = text;
  without.erase(without.find("invalid"));
  EXPECT_THAT(
      problems_of(without),
      HasSubstr(
          "does not hold in 2 of 8 points, first for cavity_center_height = 3 um, cavity_radius = 3.5 um"));
}

TEST(Design, ARequirementOfDifferentUnitsIsRefusedWhetherItHoldsOrNot) {
  for (const char* require : {"cavity_radius > impact_speed", "impact_speed > cavity_radius",
                              "cavity_radius > 1 s", "1 s > cavity_radius", "impact_speed < 0.1 um"})
    EXPECT_THAT(problems_of(study_text({}, std::string("[sweep]\nrequire = \"") + require + "\"\n")),
                HasSubstr("adds or compares quantities of different units"))
        << require;
}

}  // namespace
}  // namespace mpmstudy
