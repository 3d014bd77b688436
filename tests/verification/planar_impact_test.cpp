// Planar impact against the exact elastic-plastic states, at 0.05 um cells with default numerics: the
// accuracy that the project promises.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/libmpm/scenes.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

using mpm::verification::number_of;
using mpm::verification::planar_impact_numbers;

class PlanarImpact : public testing::TestWithParam<int> {};
TEST_P(PlanarImpact, ReachesTheExactState) { expect_all_hold(planar_impact_numbers(GetParam(), {})); }
INSTANTIATE_TEST_SUITE_P(Speeds, PlanarImpact, testing::Values(20, 1120, 1500),
                         [](const auto& info) { return "u" + std::to_string(info.param); });

TEST(PlanarImpactAt200, ReachesTheExactState) {
  const auto numbers = planar_impact_numbers(200, {});
  expect_all_hold(numbers);
  EXPECT_LT(number_of(numbers, "elastic limit stress").error(), 0.005);
}

// The noise of one particle per cell grows with the compression, here to two thirds of the volume, and does
// not fall with the cell. A smoother shape function on more particles has none of it.
TEST(PlanarImpactAt3000, ReachesTheExactState) {
  for (const auto& n : planar_impact_numbers(3000, {})) {
    if (n.quantity == "plateau noise")
      EXPECT_LT(n.error(), 0.025);
    else
      expect_holds(n);
  }
  expect_all_hold(planar_impact_numbers(
      3000, {.cells = 2, .scheme = mpm::ShapeFunction::bspline3, .particles_per_cell = 9}));
}

TEST(PlanarImpactOverdriven, LeavesNoPrecursor) {
  const mpm::RunResult r = mpm::run(scenes::planar(1120, 20e-6, 0.1e-6, 4e-9));
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_TRUE(std::isnan(scenes::metric(r, "elastic_wave_speed_m_s")));
  EXPECT_FALSE(std::isnan(scenes::metric(r, "plastic_wave_speed_m_s")));
}

}  // namespace
