#include "libmpm/verification/exact/verney.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "csv.hpp"

namespace {

using namespace mpm::verification::exact;

/// The aluminium shell of the table: 1.5 to 3 um, Y0 = 120 MPa.
ImplodingShell aluminium(double hardening) { return {1.5e-6, 3e-6, 2700, 120e6, hardening}; }
constexpr ImplodingShell beryllium{80e-3, 100e-3, 1845, 330e6, 0};

TEST(Verney, AgreesWithEveryRowOfTheTable) {
  const auto rows = read_reference("verney_cylinder_al.csv");
  ASSERT_EQ(rows.size(), 5u);
  for (const CsvRow& row : rows) {
    SCOPED_TRACE("u0 = " + row.at("u0_m_s") + " m/s");
    const double u0 = number(row, "u0_m_s");
    const double half_digit = 0.6e-4;  // of the table's four decimals
    expect_close(verney_speed(aluminium(0), number(row, "a_stop_exact_H0_um") * 1e-6), row, "u0_m_s", 1,
                 1e-6);
    expect_close(verney_stop_radius(aluminium(0), u0), row, "a_stop_exact_H0_um", 1e-6, 1e-5);
    expect_close(verney_stop(aluminium(0), u0).time, row, "t_stop_H0_ns", 1e-9, half_digit);
    const ShellStop literal = verney_stop(aluminium(std::sqrt(1.5) * 384e6), u0);
    expect_close(literal.radius, row, "a_stop_H470.3_um", 1e-6, half_digit / 0.75);
    expect_close(literal.time, row, "t_stop_H470.3_ns", 1e-9, half_digit);
    expect_close(verney_stop(aluminium(384e6), u0).radius, row, "a_stop_H384_um", 1e-6, half_digit / 0.75);
  }
}

/// Computed for the design of this problem by another program: stop radius, speed, time, outer radius.
TEST(Verney, BerylliumSphere) {
  ImplodingShell sphere = beryllium;
  sphere.spherical = true;
  const struct {
    double stop, speed, time, outer;
  } rows[] = {{30e-3, 675.04, 103.3e-6, 80.16e-3},
              {40e-3, 619.79, 98.99e-6, 82.03e-3},
              {50e-3, 545.14, 91.68e-6, 84.95e-3}};
  for (const auto& row : rows) {
    EXPECT_NEAR(verney_speed(sphere, row.stop), row.speed, 0.006);
    EXPECT_NEAR(outer_radius(sphere, row.stop), row.outer, 0.006e-3);
    const ShellStop stop = verney_stop(sphere, row.speed);
    EXPECT_NEAR(stop.radius / row.stop, 1, 1e-4);
    EXPECT_NEAR(stop.time / row.time, 1, 5e-4);
  }
}

TEST(Verney, BerylliumOfTheLiterature) {
  EXPECT_NEAR(outer_radius(beryllium, 50e-3), 78.10e-3, 0.005e-3);
  EXPECT_NEAR(verney_speed(beryllium, 50e-3), 417.079, 417 * 2e-6);
  const ShellStop stop = verney_stop(beryllium, 417.079);
  EXPECT_NEAR(stop.time, 129.10e-6, 0.005e-6);
  EXPECT_NEAR(stop.radius, 50e-3, 50e-3 * 1e-5);
}

TEST(Verney, EquationOfMotionAgreesWithTheEnergyBalance) {
  for (const double part : {0.9, 0.6, 0.3, 0.1}) {
    const double radius = part * 1.5e-6;
    const ShellStop stop = verney_stop(aluminium(0), verney_speed(aluminium(0), radius));
    EXPECT_FALSE(stop.closes);
    EXPECT_NEAR(stop.radius / radius, 1, 1e-9) << part;
  }
}

TEST(Verney, ClosesAboveAFiniteSpeed) {
  const double limit = verney_speed(aluminium(0), 0);
  EXPECT_EQ(verney_stop_radius(aluminium(0), limit * 1.01), 0);
  EXPECT_TRUE(verney_stop(aluminium(0), limit * 1.01).closes);
  EXPECT_GT(verney_stop_radius(aluminium(0), limit * 0.99), 0);
}

TEST(Verney, DependsOnRatiosOfLengthsOnly) {
  ImplodingShell large = aluminium(384e6);
  large.inner_radius *= 1024;
  large.outer_radius *= 1024;
  const ShellStop small_stop = verney_stop(aluminium(384e6), 200);
  const ShellStop large_stop = verney_stop(large, 200);
  EXPECT_NEAR(large_stop.radius / small_stop.radius, 1024, 1024 * 1e-12);
  EXPECT_NEAR(large_stop.time / small_stop.time, 1024, 1024 * 1e-12);
}

TEST(Verney, RefusesImpossibleInput) {
  EXPECT_THROW(verney_speed(aluminium(1), 1e-6), std::invalid_argument);
  EXPECT_THROW(verney_speed(aluminium(0), 2e-6), std::invalid_argument);
  EXPECT_THROW(verney_stop(aluminium(0), 0), std::invalid_argument);
  EXPECT_THROW(verney_stop({2e-6, 1e-6, 2700, 1e8, 0}, 10), std::invalid_argument);
}

TEST(PoreCollapse, PressuresOfPerfectPlasticity) {
  const double y = 120e6, g = 25.93985e9, sqrt3 = std::numbers::sqrt3;
  EXPECT_NEAR(pore_collapse_pressure(y, std::exp(-1.0)), y / sqrt3, y * 1e-12);
  EXPECT_NEAR(pore_first_yield_pressure(y), y / sqrt3, y * 1e-12);
  EXPECT_NEAR(lone_pore_collapse_pressure(y, g), 0.48e9, 0.005e9);
  EXPECT_THROW(pore_collapse_pressure(y, 1), std::invalid_argument);
}

}  // namespace
