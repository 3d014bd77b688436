// A cavity that a far pressure closes, against closed forms.
#include "libmpm/verification/exact/pressed_cavity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace mpm::verification::exact;

constexpr PressedCavity aluminium{1e-6, 2700, 0.12e9, 25.9e9};

TEST(PressedCavity, IsHeldWithoutAJumpWhereItYields) {
  const double ratio = aluminium.yield_stress / (2 * aluminium.shear_modulus);
  const double yields = aluminium.radius / std::cbrt(1 + ratio);
  for (const double side : {1 - 1e-9, 1 + 1e-9})
    EXPECT_NEAR(holding_pressure(aluminium, yields * side), 2.0 / 3 * aluminium.yield_stress, 1e3);
  EXPECT_EQ(holding_pressure(aluminium, aluminium.radius), 0);
}

// Without strength Rayleigh's cavity: 0.914681 a0 sqrt(rho / P).
TEST(PressedCavity, WithoutStrengthIsRayleighs) {
  PressedCavity weak = aluminium;
  weak.yield_stress = 1e-3;
  const double pressure = 1e8;
  const CavityStop stop = pressed_cavity_stop(weak, pressure);
  EXPECT_TRUE(stop.closes);
  EXPECT_NEAR(stop.time / (weak.radius * std::sqrt(weak.density / pressure)), 0.914681, 1e-5);
}

// Where the work of the far pressure is that of the holding pressure: the integral of both over a^2 da.
TEST(PressedCavity, StopsWhereItsEnergyIsSpent) {
  for (const double share : {0.5, 0.8, 0.95}) {
    const double pressure = share * closing_pressure(aluminium);
    const CavityStop stop = pressed_cavity_stop(aluminium, pressure);
    ASSERT_FALSE(stop.closes);
    double work = 0;
    constexpr int count = 2000000;
    const double step = (aluminium.radius - stop.radius) / count;
    for (int k = 0; k < count; ++k) {
      const double a = stop.radius + (k + 0.5) * step;
      work += (pressure - holding_pressure(aluminium, a)) * a * a * step;
    }
    EXPECT_NEAR(work / (pressure * std::pow(aluminium.radius, 3) / 3), 0, 1e-6) << share;
  }
}

TEST(PressedCavity, ClosesAboveAPressure) {
  const double closing = closing_pressure(aluminium);
  EXPECT_NEAR(closing, 0.5654e9, 0.0001e9);
  EXPECT_FALSE(pressed_cavity_stop(aluminium, 0.99 * closing).closes);
  EXPECT_TRUE(pressed_cavity_stop(aluminium, 1.01 * closing).closes);
  EXPECT_TRUE(std::isinf(pressed_cavity_time(aluminium, 0.5 * closing, 0.5 * aluminium.radius)));
}

}  // namespace
