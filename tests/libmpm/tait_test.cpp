// Tait's equation against its formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/eos/temperature.hpp"
#include "tests/libmpm/driven.hpp"

namespace {

using driven::Driven;
using mpm::Material;

// Pressure, sound and energy by the density alone, at once and in closed form.
TEST(Tait, FollowsItsDensity) {
  Material m = mpm::named_material("water-tait");
  m.tension = mpm::Tension::polynomial;
  for (const double rate : {-1e-6, 3e-7}) {
    Driven point(m);
    point.strain({rate, 0, 0, rate}, 1e-9, 50000);
    const double x = 1 / (1 + point.dilation);
    const double exact = m.tait_pressure * (std::pow(x, m.tait_exponent) - 1);
    EXPECT_NEAR(point.pressure / exact, 1, 1e-12);
    EXPECT_NEAR(point.longitudinal_square,
                m.tait_exponent * (exact + m.tait_pressure) / (m.reference_density * x),
                1e-9 * point.longitudinal_square);
    // from -P dV, by steps
    const double n = m.tait_exponent;
    const double energy =
        m.tait_pressure / m.reference_density * ((std::pow(x, n - 1) - 1) / (n - 1) + 1 / x - 1);
    EXPECT_NEAR(point.energy / energy, 1, 1e-6);
    EXPECT_NEAR(mpm::Temperature(m)(point.dilation, energy), m.initial_temperature, 1e-6);
    EXPECT_NEAR(mpm::Temperature(m)(point.dilation, energy + m.specific_heat), m.initial_temperature + 1,
                1e-6);
    EXPECT_EQ(point.mises(), 0);
  }
  EXPECT_NEAR(mpm::sound_speed_at_rest(m), 1482, 1e-9);
  EXPECT_TRUE(mpm::state_columns(m).empty());
}

TEST(Tait, Cavitates) {
  Driven point(mpm::named_material("water-tait"));
  point.strain({1e-4, 0, 0, 1e-4}, 1e-9, 100);
  EXPECT_EQ(point.pressure, 0);
}

// The shock that shock_speed() names keeps mass and momentum.
TEST(Tait, KnowsItsHugoniot) {
  const Material m = mpm::named_material("water-tait");
  for (const double up : {1.0, 100.0, 500.0}) {
    const double us = mpm::shock_speed(m, up), x = us / (us - up);
    EXPECT_NEAR(m.reference_density * us * up / (m.tait_pressure * (std::pow(x, m.tait_exponent) - 1)), 1,
                1e-9);
    EXPECT_GT(us, 1482 + up);
  }
}

}  // namespace
