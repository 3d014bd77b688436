// The health of a run: each limit trips, says where, and leaves a picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "libmpm/measure/energy.hpp"
#include "libmpm/measure/health.hpp"
#include "libmpm/scene/build.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::Health;
using testing::HasSubstr;

struct HealthTest : testing::Test {
  mpm::Scene scene = scenes::cavity(0.2e-6);
  mpm::State state = mpm::build_state(scene);
  Health health{scene, state, scene.impact_speed};
  mpm::StepReport report = [] {
    mpm::StepReport r;
    r.largest_signal = 7000;
    return r;
  }();
  double dt = 0.4 * 0.2e-6 / 7000;

  double mass() const {
    return std::accumulate(state.particles.mass.begin(), state.particles.mass.end(), 0.0);
  }
  std::string said(double energy_error = 0) {
    health.after_step(state, report, dt);
    return health.describe(health.trouble(energy_error), state, energy_error);
  }
};

TEST_F(HealthTest, SaysNothingOfAGoodStep) { EXPECT_EQ(said(), ""); }

TEST_F(HealthTest, FindsTheParticleThatIsNotFinite) {
  state.particles.energy[17] = std::numeric_limits<double>::quiet_NaN();
  report.largest_signal = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(said(), HasSubstr("particle 17 at x = "));
}

TEST_F(HealthTest, FindsTheParticleThatLeft) {
  state.particles.position[23].x() = 20e-6;
  report.largest_signal = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(said(), HasSubstr("particle 23 at x = 2e-05 m"));
}

TEST_F(HealthTest, FindsTheLeastDensity) {
  state.particles.dilation[5] = report.largest_dilation = 9;
  report.overstrained_mass = 0.009 * mass();
  EXPECT_EQ(said(), "");
  report.overstrained_mass = 0.011 * mass();
  EXPECT_THAT(said(),
              testing::AllOf(HasSubstr("density left its range: rho0/rho from 1 to 10, 1.1 % of the mass"),
                             HasSubstr("particle 5 at"), HasSubstr("try a smaller cfl")));
}

TEST_F(HealthTest, FindsAParticleThatIsCrushed) {
  state.particles.dilation[7] = report.smallest_dilation = -0.96;
  EXPECT_THAT(said(), testing::AllOf(HasSubstr("rho0/rho from 0.04 to 1"), HasSubstr("particle 7 at")));
}

TEST_F(HealthTest, CatchesMotionThatGrowsByItself) {
  const double initial = mpm::energy_of(state.particles).total();
  report.kinetic_energy = 1.009 * initial;
  EXPECT_EQ(said(), "");
  report.kinetic_energy = 1.011 * initial;
  EXPECT_THAT(said(), HasSubstr("the motion grows by itself"));
}

TEST_F(HealthTest, AllowsSinglePressuresBeyondTheEquationOfState) {
  report.overpressed_mass = 0.009 * mass();
  EXPECT_EQ(said(), "");
  report.overpressed_mass = 0.011 * mass();
  EXPECT_THAT(said(), HasSubstr("1.1 % of the mass is beyond the equation of state"));
}

// Or the run would go on for ever, in steps that become shorter and shorter.
TEST_F(HealthTest, CatchesASignalThatNothingPhysicalHas) {
  report.largest_signal = 1e6;
  dt = 0.4 * 0.2e-6 / report.largest_signal;
  EXPECT_THAT(said(), HasSubstr("the fastest signal is 1e+06 m/s"));
}

TEST_F(HealthTest, CatchesAStepThatIsTooLong) {
  dt = 1.01 * state.grid.cell().minCoeff() / report.largest_signal;
  EXPECT_THAT(said(), HasSubstr("the time step was too long: CFL number 1.01, allowed 1"));
}

TEST_F(HealthTest, CatchesLostEnergyAndWhatIsNotANumber) {
  EXPECT_THAT(said(0.011), HasSubstr("energy error 0.011, allowed 0.01"));
  EXPECT_THAT(said(std::nan("")), HasSubstr("energy error nan"));
}

TEST(Health, LeavesTheLastPictureOfARunThatBreaksDown) {
  struct Pictures : mpm::Observer {
    std::vector<std::int64_t> steps;
    void on_snapshot(const mpm::Snapshot& s) override { steps.push_back(s.step); }
  } pictures;
  const mpm::RunResult r = mpm::run(scenes::planar(20000, 2e-6, 0.1e-6, 1e-9), pictures);
  ASSERT_EQ(r.status, mpm::RunStatus::failed);
  EXPECT_THAT(pictures.steps, testing::ElementsAre(r.steps));
  EXPECT_THAT(r.reason, HasSubstr("lower the speed"));
  EXPECT_GT(scenes::metric(r, "largest_density_ratio"), 1.1);
}

TEST(Health, IsPartOfEveryResult) {
  const mpm::RunResult r = mpm::run(scenes::cavity(0.2e-6));
  ASSERT_EQ(r.status, mpm::RunStatus::done);
  EXPECT_GT(scenes::metric(r, "largest_density_ratio"), 1);
  EXPECT_LT(scenes::metric(r, "smallest_density_ratio"), 1);
  EXPECT_GT(scenes::metric(r, "largest_cfl"), 0.2);
  EXPECT_LT(scenes::metric(r, "largest_cfl"), 1);
}

}  // namespace
