// The imploding shell against the closed form and the one-dimensional code, at 0.1 um cells.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/shell_cases.hpp"

namespace {

using mpm::verification::number_of;

class ImplodingShell : public testing::TestWithParam<ShellCase> {};

// The tolerances against the one-dimensional code are those of 0.05 um cells: see the slow test.
TEST_P(ImplodingShell, StopsWhereItShould) {
  const auto numbers =
      mpm::verification::imploding_shell_numbers(GetParam().inner_speed, GetParam().hardening, {.cells = 2});
  for (const char* quantity : {"stop radius", "stop time", "roundness", "energy error", "momentum error"})
    expect_holds(number_of(numbers, quantity));
  EXPECT_LT(number_of(numbers, "stop radius, compressible").error(), 0.002);
  EXPECT_LT(number_of(numbers, "stop time, compressible").error(), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Speeds, ImplodingShell, testing::ValuesIn(shell_cases), name_of_shell);

TEST(ImplodingShellSymmetry, QuarterIsTheRing) {
  mpm::Scene s = scenes::shell(185.0293, 0.2e-6);
  const mpm::RunResult quarter = mpm::run(s);
  s.numerics.symmetry = mpm::Symmetry::full;
  const mpm::RunResult ring = mpm::run(s);
  ASSERT_EQ(ring.status, mpm::RunStatus::done) << ring.reason;
  EXPECT_EQ(ring.outcome, "arrested");
  EXPECT_LT(ring.energy_error, 1e-12);
  EXPECT_EQ(ring.particles, 4 * quarter.particles);
  EXPECT_NEAR(scenes::metric(ring, "stop_radius_m") / scenes::metric(quarter, "stop_radius_m"), 1, 1e-9);
  EXPECT_NEAR(scenes::metric(ring, "stop_time_s") / scenes::metric(quarter, "stop_time_s"), 1, 1e-9);
}

// Nothing but the numerics says when the run is over: a shell that is still moving at end_time has no stop.
TEST(ImplodingShellEnd, AMovingShellIsUndecided) {
  mpm::Scene s = scenes::shell(185.0293, 0.2e-6);
  s.end_time = 1e-9;
  const mpm::RunResult r = mpm::run(s);
  EXPECT_EQ(r.outcome, "undecided");
  EXPECT_TRUE(std::isnan(scenes::metric(r, "stop_radius_m")));
}

}  // namespace
