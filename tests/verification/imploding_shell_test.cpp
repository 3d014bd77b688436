#include "tests/verification/imploding_shell.hpp"

namespace {

class ImplodingShell : public testing::TestWithParam<shell::Case> {};

TEST_P(ImplodingShell, StopsWhereItShould) {
  const mpm::Scene s = shell::scene(GetParam(), 0.1e-6);
  const mpm::RunResult r = mpm::run(s);
  shell::expect_good_run(r);
  const shell::Errors to_formula = shell::errors(r, shell::incompressible(s));
  EXPECT_NEAR(to_formula.radius, 0, 0.01);
  EXPECT_NEAR(to_formula.time, 0, 0.02);
  const shell::Errors to_code = shell::errors(r, shell::compressible(s));
  EXPECT_NEAR(to_code.radius, 0, 0.002);
  EXPECT_NEAR(to_code.time, 0, 0.01);
  EXPECT_LT(scenes::metric(r, "roundness"), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Speeds, ImplodingShell, testing::ValuesIn(shell::cases),
                         [](const auto& info) { return shell::name_of(info.param); });

TEST(ImplodingShellSymmetry, QuarterIsTheRing) {
  mpm::Scene s = shell::scene({185.0293, true}, 0.2e-6);
  const mpm::RunResult quarter = mpm::run(s);
  s.numerics.symmetry = mpm::Symmetry::full;
  const mpm::RunResult ring = mpm::run(s);
  shell::expect_good_run(ring);
  EXPECT_EQ(ring.particles, 4 * quarter.particles);
  EXPECT_NEAR(scenes::metric(ring, "stop_radius_m") / scenes::metric(quarter, "stop_radius_m"), 1, 1e-9);
  EXPECT_NEAR(scenes::metric(ring, "stop_time_s") / scenes::metric(quarter, "stop_time_s"), 1, 1e-9);
}

// Nothing but the numerics says when the run is over: a shell that is still moving at end_time has no stop.
TEST(ImplodingShellEnd, AMovingShellIsUndecided) {
  mpm::Scene s = shell::scene({185.0293, true}, 0.2e-6);
  s.end_time = 1e-9;
  const mpm::RunResult r = mpm::run(s);
  EXPECT_EQ(r.outcome, "undecided");
  EXPECT_TRUE(std::isnan(scenes::metric(r, "stop_radius_m")));
}

}  // namespace
