// Material points of the strengths and equations of state beside von Mises and Mie-Grueneisen, against closed
// forms and an integration of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/material/list.hpp"
#include "tests/libmpm/driven.hpp"

namespace {

using driven::Driven;
using mpm::Material;

Material copper_of_johnson_cook() {
  Material m = mpm::named_material("copper");
  m.strength = mpm::StrengthModel::johnson_cook;
  m.yield_stress = 90e6;
  m.strain_hardening = 292e6;
  m.hardening_exponent = 0.31;
  m.rate_hardening = 0.025;
  m.reference_strain_rate = 1;
  m.softening_exponent = 1.09;
  m.melting_temperature = 1356;
  return m;
}

Material liquid() {
  Material m = mpm::named_material("copper");
  m.eos = mpm::EquationOfState::stiffened_gas;
  m.strength = mpm::StrengthModel::none;
  m.reference_density = 1000;
  m.adiabatic_index = 4.4;
  m.stiffening_pressure = 600e6;
  m.specific_heat = 4180;
  return m;
}

/// Pure shear of volume: the flow stress follows from p, its rate and the plastic work; an integration in p
/// with far smaller steps is the oracle.
TEST(JohnsonCook, FollowsItsFlowStressInShear) {
  for (const double softening : {0.0, 1.09})
    for (const double rate_effect : {0.0, 0.025}) {
      Material m = copper_of_johnson_cook();
      m.softening_exponent = softening, m.rate_hardening = rate_effect;
      const double rate = 1e5, total = 0.5;  // of the shear angle
      const int steps = 200000;
      Driven point(m);
      const double dt = total / steps / rate, h = total / steps;
      // (1 + l) of determinant 1: a shear, without turning of the axes of stress at this size of step
      point.strain({0, h, 0, 0}, dt, steps);
      // q' = sqrt(3) G gamma' - 3 G p': elastic, then p' holds q on the surface
      const double g = m.shear_modulus(),
                   heat = m.specific_heat * (m.melting_temperature - m.initial_temperature);
      double p = 0, work = 0, q = 0;
      const int fine = 2000000;
      for (int k = 0; k < fine; ++k) {
        const double trial = q + std::sqrt(3.0) * g * total / fine;
        const auto flow = [&](double dp) {
          const double pdot = dp / (total / fine / rate);
          const double ratio = pdot / m.reference_strain_rate;
          return (m.yield_stress + m.strain_hardening * std::pow(p + dp, m.hardening_exponent)) *
                 (1 + rate_effect * (ratio > 1 ? std::log(ratio) : 0)) *
                 (softening > 0 ? 1 - std::pow(work / heat, softening) : 1);
        };
        double low = 0, high = trial / (3 * g);
        if (trial - flow(0) > 0) {
          for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (trial - 3 * g * middle > flow(middle) ? low : high) = middle;
          }
          p += low, q = trial - 3 * g * low;
          work += q * low / m.reference_density;
        } else {
          q = trial;
        }
      }
      EXPECT_NEAR(point.own[mpm::own_plastic_strain] / p, 1, 1e-5) << softening << " " << rate_effect;
      EXPECT_NEAR(point.mises() / q, 1, 1e-5) << softening << " " << rate_effect;
      EXPECT_NEAR(point.own[mpm::own_plastic_work] / work, 1, 1e-5) << softening << " " << rate_effect;
    }
}

// Without rate and heat, with n = 1, it is linear isotropic hardening: the same numbers.
TEST(JohnsonCook, WithALinearLawIsIsotropicHardening) {
  Material jc = copper_of_johnson_cook();
  jc.hardening_exponent = 1, jc.rate_hardening = 0, jc.softening_exponent = 0;
  Material j2 = mpm::named_material("copper");
  j2.yield_stress = jc.yield_stress, j2.hardening_modulus = jc.strain_hardening;
  j2.hardening_measure = mpm::HardeningMeasure::equivalent;
  Driven a(jc), b(j2);
  a.strain({-1e-4, 3e-4, 1e-4, 5e-5}, 1e-10, 1000), b.strain({-1e-4, 3e-4, 1e-4, 5e-5}, 1e-10, 1000);
  EXPECT_GT(b.own[mpm::own_plastic_strain], 0.05);
  EXPECT_NEAR(a.own[mpm::own_plastic_strain] / b.own[mpm::own_plastic_strain], 1, 1e-10);
  EXPECT_NEAR(a.own[mpm::own_plastic_work] / b.own[mpm::own_plastic_work], 1, 1e-4);  // both of second order
  EXPECT_NEAR(a.mises() / b.mises(), 1, 1e-10);
  EXPECT_NEAR(a.pressure / b.pressure, 1, 1e-10);
}

TEST(JohnsonCook, HasNoStrengthWhereItMelts) {
  Material m = copper_of_johnson_cook();
  Driven point(m);
  point.own[mpm::own_plastic_work] = 2 * m.specific_heat * (m.melting_temperature - m.initial_temperature);
  point.strain({0, 1e-3, 0, 0}, 1e-9, 10);
  EXPECT_LT(point.mises(), 1);
}

/// de = -P dv along an isentrope: (P + P_inf) (rho0 / rho)^gamma does not change.
TEST(StiffenedGas, FollowsItsIsentrope) {
  const Material m = liquid();
  for (const double rate : {-2e-6, 1e-6}) {
    Driven point(m);
    point.strain({rate, 0, 0, rate}, 1e-9, 50000);
    const double compressed = 1 / (1 + point.dilation);
    const double exact = m.stiffening_pressure * (std::pow(compressed, m.adiabatic_index) - 1);
    EXPECT_NEAR(point.pressure / exact, 1, 1e-6);
    EXPECT_NEAR(point.longitudinal_square / (m.adiabatic_index * (exact + m.stiffening_pressure) /
                                             (m.reference_density * compressed)),
                1, 1e-3);  // by the pressure of the step before
    const mpm::Temperature temperature(m);
    EXPECT_NEAR(temperature(point.dilation, point.energy) /
                    (m.initial_temperature * std::pow(compressed, m.adiabatic_index - 1)),
                1, 1e-6);
    EXPECT_EQ(point.mises(), 0);
  }
  EXPECT_NEAR(mpm::sound_speed_at_rest(m), std::sqrt(4.4 * 600e6 / 1000), 1e-9);
}

// The shock that shock_speed() names keeps mass, momentum and energy.
TEST(StiffenedGas, KnowsItsHugoniot) {
  Material m = liquid();
  for (const double stiff : {600e6, 0.0})
    for (const double up : {10.0, 500.0}) {
      m.stiffening_pressure = stiff;
      const double us = mpm::shock_speed(m, up), rho = 1000 * us / (us - up), p = 1000 * us * up;
      const double by_eos = 3.4 * rho * (up * up / 2) + 4.4 * stiff * (rho / 1000 - 1);
      EXPECT_NEAR(p / by_eos, 1, 1e-12) << stiff << " " << up;
    }
}

TEST(Fluid, OfMieGrueneisenHasPressureAlone) {
  Material m = mpm::named_material("copper");
  const double solid = mpm::sound_speed_at_rest(m);
  m.strength = mpm::StrengthModel::none;
  EXPECT_NEAR(mpm::sound_speed_at_rest(m), m.bulk_sound_speed, 1e-9);
  EXPECT_GT(solid, 1.1 * m.bulk_sound_speed);
  Driven fluid(m), like_copper(mpm::named_material("copper"));
  fluid.strain({-1e-4, 0, 0, -1e-4}, 1e-9, 100), like_copper.strain({-1e-4, 0, 0, -1e-4}, 1e-9, 100);
  EXPECT_EQ(fluid.mises(), 0);
  EXPECT_GT(fluid.pressure, 1e9);
  EXPECT_NEAR(fluid.pressure / like_copper.pressure, 1, 1e-3);  // but for the heat of plastic work
  EXPECT_TRUE(mpm::state_columns(m).empty());
}

/// Beyond the failure strain there is neither deviator nor tension; up to it nothing has changed.
TEST(Failure, TakesDeviatorAndTensionForGood) {
  for (const auto strength : {mpm::StrengthModel::von_mises, mpm::StrengthModel::johnson_cook})
    for (const double kinematic : {0.0, 0.5}) {
      Material whole = copper_of_johnson_cook();
      whole.strength = strength;
      whole.hardening_modulus = 300e6, whole.kinematic_fraction = kinematic;
      Material failing = whole;
      failing.failure_strain = 0.1;
      Driven a(whole), b(failing);
      const mpm::Gradient<double> stretch{1e-5, 2e-4, 0, 1e-5};
      while (a.own[mpm::own_plastic_strain] < 0.0999)
        a.strain(stretch, 1e-10, 1), b.strain(stretch, 1e-10, 1);
      EXPECT_EQ(a.mises(), b.mises());
      EXPECT_EQ(a.pressure, b.pressure);
      EXPECT_LT(b.pressure, -1e6);
      a.strain(stretch, 1e-10, 10);
      const double energy = b.energy;
      b.strain(stretch, 1e-10, 10);
      EXPECT_GT(a.mises(), 1e8);
      EXPECT_EQ(b.mises(), 0);
      EXPECT_EQ(b.pressure, 0);
      EXPECT_GT(b.energy, 0.99 * energy);  // the energy of the lost stress stays
      b.strain({-1e-3, 0, 0, -1e-3}, 1e-10, 50);
      EXPECT_GT(b.pressure, 1e9);
      EXPECT_EQ(b.mises(), 0);
    }
}

TEST(Materials, WithoutAModelSaySo) {
  Material m = mpm::named_material("copper");
  EXPECT_TRUE(mpm::has_model(m));
  m.tension = mpm::Tension::linear;
  EXPECT_TRUE(mpm::has_model(m));
  m.failure_strain = 0.5;
  EXPECT_FALSE(mpm::has_model(m));
  m.yield_stress = std::numeric_limits<double>::infinity();  // what is elastic does not fail
  EXPECT_TRUE(mpm::has_model(m));
  m = liquid();
  m.strength = mpm::StrengthModel::von_mises;
  EXPECT_FALSE(mpm::has_model(m));
}

}  // namespace
