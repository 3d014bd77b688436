// The model has no length and no time of its own: lengths and times multiplied by a power of two give the
// same dimensionless results, bit for bit.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libmpm/scenes.hpp"

namespace {

void scale(mpm::Scene& s, double k) {
  for (double* v : {&s.block_width, &s.block_height, &s.cavity_radius, &s.cavity_center_height, &s.end_time,
                    &s.numerics.cell_size, &s.measures.area_every, &s.measures.detached_for})
    *v *= k;
}

void expect_scaled_bits(mpm::Scene s, double k) {
  const mpm::RunResult small = mpm::run(s);
  scale(s, k);
  const mpm::RunResult large = mpm::run(s);
  ASSERT_EQ(small.status, mpm::RunStatus::done);
  EXPECT_EQ(large.steps, small.steps);
  EXPECT_EQ(large.energy_error, small.energy_error);
  EXPECT_EQ(large.collapsibility, small.collapsibility);
  EXPECT_EQ(large.collapsibility_error, small.collapsibility_error);
  ASSERT_EQ(large.area_history.size(), small.area_history.size());
  for (std::size_t i = 0; i < small.area_history.size(); ++i) {
    EXPECT_EQ(large.area_history[i].time, k * small.area_history[i].time);
    EXPECT_EQ(large.area_history[i].area, k * k * small.area_history[i].area);
    EXPECT_EQ(large.area_history[i].void_area, k * k * small.area_history[i].void_area);
  }
  ASSERT_EQ(large.metrics.size(), small.metrics.size());
  for (std::size_t i = 0; i < small.metrics.size(); ++i) {
    const mpm::Metric& m = small.metrics[i];
    const double factor = m.unit == "m" || m.unit == "s" ? k : m.unit == "m2" || m.unit == "kg/m" ? k * k : 1;
    EXPECT_EQ(large.metrics[i].value, factor * m.value) << m.name;
  }
}

TEST(Scale, WeakCollapse) { expect_scaled_bits(scenes::cavity(0.2e-6), 1024); }

TEST(Scale, StrongCollapse) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.impact_speed = 1120;
  s.end_time = 0.5e-9;  // before the jet, whose pressure is beyond the equation of state
  expect_scaled_bits(s, 1024);
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
  expect_scaled_bits(s, 1024);
}

TEST(Scale, PlanarImpactWithEitherScheme) {
  mpm::Scene s = scenes::planar(200, 10e-6, 0.1e-6, 2e-9);
  expect_scaled_bits(s, 1024);
  s.numerics.scheme = mpm::ShapeFunction::bspline2;
  expect_scaled_bits(s, std::ldexp(1.0, -20));
}

}  // namespace
