// The model has no length and no time of its own: lengths and times multiplied by a power of two give the
// same dimensionless results, bit for bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/verification/problems/invariances.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::verification::differing_when_scaled;
using testing::IsEmpty;

TEST(Scale, WeakCollapse) { EXPECT_THAT(differing_when_scaled(scenes::cavity(0.2e-6), 1024), IsEmpty()); }

TEST(Scale, SphericalCollapse) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.space = mpm::Space::axisymmetric;
  EXPECT_THAT(differing_when_scaled(s, 1024), IsEmpty());
}

TEST(Scale, CollapseOfThreeAxes) {
  mpm::Scene s = scenes::in_space(mpm::Space::three_d, scenes::cavity(0.5e-6));
  s.block_width = 5e-6;
  EXPECT_THAT(differing_when_scaled(s, 1024), IsEmpty());
}

TEST(Scale, StrongCollapse) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.impact_speed = 1120;
  s.end_time = 0.5e-9;  // before the jet, whose pressure is beyond the equation of state
  EXPECT_THAT(differing_when_scaled(s, 1024), IsEmpty());
}

TEST(Scale, Ejection) {
  mpm::Scene s = scenes::cavity(0.3e-6);
  s.impact_speed = 900;
  s.block_height = 6e-6;
  s.cavity_center_height = 4e-6;  // a wall of half a micrometre
  s.end_time = 8e-9;
  s.measures.detached_for = 1e-9;
  s.measures.decides = mpm::Decides::ejection;
  ASSERT_EQ(mpm::run(s).outcome, "ejected");
  EXPECT_THAT(differing_when_scaled(s, 1024), IsEmpty());
}

TEST(Scale, PlanarImpactWithEitherScheme) {
  mpm::Scene s = scenes::planar(200, 10e-6, 0.1e-6, 2e-9);
  EXPECT_THAT(differing_when_scaled(s, 1024), IsEmpty());
  s.numerics.scheme = mpm::ShapeFunction::bspline2;
  EXPECT_THAT(differing_when_scaled(s, std::ldexp(1.0, -20)), IsEmpty());
}

}  // namespace
