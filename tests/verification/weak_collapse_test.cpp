// The weak collapse: trends that the physics demands, and invariances of its description.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/libmpm/scenes.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

mpm::RunResult collapse(double radius, double yield_stress) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.block_height = 6e-6;
  s.cavity_center_height = 3e-6;
  s.cavity_radius = radius;
  s.material.yield_stress = yield_stress;
  s.end_time = 8e-9;
  return mpm::run(s);
}

TEST(WeakCollapse, LargerCavitiesAndHigherYieldStressesCollapseLess) {
  double last = 1;
  for (const double radius : {1e-6, 1.5e-6, 2e-6, 2.4e-6}) {
    const mpm::RunResult r = collapse(radius, 120e6);
    ASSERT_EQ(r.status, mpm::RunStatus::done);
    EXPECT_LT(*r.collapsibility, last - 0.02) << radius;
    EXPECT_LT(r.energy_error, 1e-11);
    EXPECT_LT(scenes::metric(r, "momentum_error"), 1e-12);
    last = *r.collapsibility;
  }
  last = 1;
  for (const double yield : {60e6, 120e6, 240e6, 400e6}) {
    const mpm::RunResult r = collapse(1.5e-6, yield);
    EXPECT_LT(*r.collapsibility, last - 0.02) << yield;
    last = *r.collapsibility;
  }
}

TEST(WeakCollapse, HalfOfTheSceneIsTheSceneAtEarlyTimes) {
  expect_all_hold(mpm::verification::half_and_full_numbers({}));
}

}  // namespace
