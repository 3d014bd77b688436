// Planar impact against the exact elastic-plastic states.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libmpm/scenes.hpp"

namespace {

/// Rows of ep_twowave.csv (hardening read as in the paper): speed, Lagrangian speeds of the precursor and of
/// the plastic wave, normal and von Mises stress. Overdriven: no precursor.
struct Exact {
  double impact_speed, elastic_speed, plastic_speed, normal_stress, von_mises;
};
constexpr Exact rows[] = {
    {20, 6454.012, 5402.57, 0.33407e9, 120.2944e6},
    {200, 6454.012, 5643.004, 3.079873e9, 130.4179e6},
    {1120, 0, 6860.754, 20.74692e9, 174.8237e6},
    {1500, 0, 7357.281, 29.79699e9, 190.3372e6},
};

class PlanarImpact : public testing::TestWithParam<Exact> {};

TEST_P(PlanarImpact, ReachesTheExactState) {
  const Exact exact = GetParam();
  // Weak fronts are as wide as a few micrometres at any cell, so the block is long; no wave comes back in
  // time.
  const mpm::RunResult r = mpm::run(scenes::planar(exact.impact_speed, 40e-6, 0.1e-6, 7.2e-9));
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_NEAR(scenes::metric(r, "shock_normal_stress_Pa") / exact.normal_stress, 1, 0.01);
  EXPECT_NEAR(scenes::metric(r, "shock_von_mises_Pa") / exact.von_mises, 1, 0.05);
  EXPECT_NEAR(scenes::metric(r, "plastic_wave_speed_m_s") / exact.plastic_speed, 1, 0.01);
  if (exact.elastic_speed > 0)
    EXPECT_NEAR(scenes::metric(r, "elastic_wave_speed_m_s") / exact.elastic_speed, 1, 0.01);
  else
    EXPECT_TRUE(std::isnan(scenes::metric(r, "elastic_wave_speed_m_s")));
  EXPECT_LT(scenes::metric(r, "plateau_noise"), 0.01);
  EXPECT_LT(r.energy_error, 1e-12);
  EXPECT_LT(scenes::metric(r, "momentum_error"), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Speeds, PlanarImpact, testing::ValuesIn(rows), [](const auto& info) {
  return "u" + std::to_string(static_cast<int>(info.param.impact_speed));
});

}  // namespace
