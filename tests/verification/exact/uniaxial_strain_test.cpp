#include "libmpm/verification/exact/uniaxial_strain.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace mpm::verification::exact;

constexpr double g = 25.93985e9, y = 120e6;
constexpr ElasticPlasticSolid hard{{2700, 5350, 1.34, 1.96, 880, 300}, g, y, 10e9};

// Formula: q = 2 G eps, then Y0 + H (2 G eps - Y0)/(3 G + H); sigma = P + 2q/3 with de = -sigma dV.
TEST(UniaxialStrain, LoadsAlongTheTwoLines) {
  const double h = hard.hardening;
  for (const double kinematic : {0.0, 0.5, 1.0})
    for (const double strain : {0.001, 0.0023, 0.003, 0.1}) {
      UniaxialStrain at(hard, kinematic);
      at.strain_to(strain);
      const double elastic = 2 * g * strain;
      EXPECT_NEAR(at.von_mises(), elastic < y ? elastic : y + h * (elastic - y) / (3 * g + h), 1e-3)
          << strain;
      EXPECT_NEAR(at.plastic_strain(), elastic < y ? 0 : (elastic - y) / (3 * g + h), 1e-13) << strain;
    }
}

// Reverse flow begins 2 (Y0 + (1 - beta) H p) below: the Bauschinger effect of the kinematic share.
TEST(UniaxialStrain, YieldsInReverseWhereTheElasticRangeEnds) {
  for (const double kinematic : {0.0, 0.5, 1.0}) {
    UniaxialStrain at(hard, kinematic);
    at.strain_to(0.05);
    const double p = at.plastic_strain(), range = at.elastic_range();
    EXPECT_NEAR(range, 2 * (y + (1 - kinematic) * hard.hardening * p), 1e-3);
    at.strain_to(at.strain() - 0.999 * range / (2 * g));
    EXPECT_EQ(at.plastic_strain(), p);
    at.strain_to(at.strain() - 0.002 * range / (2 * g));
    EXPECT_GT(at.plastic_strain(), p);
  }
}

// However the way is cut, and there and back on an elastic path.
TEST(UniaxialStrain, IsAFunctionOfThePath) {
  UniaxialStrain once(hard, 0.3), often(hard, 0.3);
  once.strain_to(0.07);
  for (int k = 1; k <= 700; ++k) often.strain_to(1e-4 * k);
  EXPECT_NEAR(often.von_mises() / once.von_mises(), 1, 1e-11);
  EXPECT_NEAR(often.specific_energy() / once.specific_energy(), 1, 1e-11);
  EXPECT_NEAR(often.wave_speed_change() / once.wave_speed_change(), 1, 1e-11);
  UniaxialStrain elastic(hard);
  elastic.strain_to(0.002);
  EXPECT_GT(elastic.specific_energy(), 0);
  elastic.strain_to(0);
  EXPECT_NEAR(elastic.normal_stress(), 0, 1e-3);
  EXPECT_NEAR(elastic.specific_energy(), 0, 1e-9);
}

// A weak shock is an isentrope to third order in its strength: speed and stress of the jump.
TEST(UniaxialStrain, IsTheLimitOfAWeakShock) {
  const ImpactState jump = elastic_plastic_impact(hard, 5);
  UniaxialStrain at(hard);
  at.strain_to(std::log(jump.density / 2700));
  EXPECT_NEAR(at.normal_stress() / jump.normal_stress, 1, 1e-6);
  EXPECT_NEAR(at.wave_speed_change() / 5, 1, 1e-6);
}

}  // namespace
