// Planar impact at 0.05 um cells, default numerics: the accuracy that the project promises.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libmpm/scenes.hpp"

namespace {

double error(const mpm::RunResult& r, const char* name, double exact) {
  return scenes::metric(r, name) / exact - 1;
}

// States of ep_twowave.csv. 20 um, so that the free surface moves before the wave comes back from the wall.
TEST(FinePlanarImpact, Overdriven1120) {
  const mpm::RunResult r = mpm::run(scenes::planar(1120, 20e-6, 0.05e-6, 7e-9));
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_NEAR(error(r, "shock_normal_stress_Pa", 20.74692e9), 0, 0.003);
  EXPECT_NEAR(error(r, "shock_von_mises_Pa", 174.8237e6), 0, 0.02);
  EXPECT_NEAR(error(r, "plastic_wave_speed_m_s", 6860.754), 0, 0.003);
  EXPECT_NEAR(error(r, "free_surface_speed_m_s", 2242.659), 0, 0.003);
  EXPECT_LT(scenes::metric(r, "plateau_noise"), 0.005);
}

TEST(FinePlanarImpact, TwoWaves200) {
  const mpm::RunResult r = mpm::run(scenes::planar(200, 20e-6, 0.05e-6, 7e-9));
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_NEAR(error(r, "shock_normal_stress_Pa", 3.079873e9), 0, 0.003);
  EXPECT_NEAR(error(r, "plastic_wave_speed_m_s", 5643.004), 0, 0.003);
  EXPECT_NEAR(error(r, "free_surface_speed_m_s", 396.5057), 0, 0.003);
  EXPECT_NEAR(error(r, "elastic_limit_stress_Pa", 259.84e6), 0, 0.03);
  EXPECT_LT(scenes::metric(r, "plateau_noise"), 0.005);
}

// The precursor is steady once it has left the toe of the plastic front behind: 40 um.
TEST(FinePlanarImpact, Precursor200) {
  const mpm::RunResult r = mpm::run(scenes::planar(200, 40e-6, 0.05e-6, 7.2e-9));
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_NEAR(error(r, "elastic_wave_speed_m_s", 6454.012), 0, 0.005);
  EXPECT_NEAR(error(r, "elastic_limit_stress_Pa", 259.84e6), 0, 0.005);
}

}  // namespace
