// Steinberg-Guinan against integrations of their own and its formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/eos/temperature.hpp"
#include "tests/libmpm/driven.hpp"

namespace {

using driven::Driven;
using mpm::Material;

double factor(const Material& m, double dilation, double energy, double pressure) {
  const double eta = 1 / (1 + dilation);
  const double temperature = dilation == 0 ? m.initial_temperature + energy / m.specific_heat
                                           : mpm::Temperature(m)(dilation, energy);
  const double melting = m.melting_temperature * std::exp(2 * m.melting_gamma_fall * (1 - 1 / eta)) *
                         std::pow(eta, 2 * (m.gruneisen_gamma - m.melting_gamma_fall - 1.0 / 3));
  if (temperature >= melting) return 0;
  return 1 + m.shear_per_pressure * pressure / std::cbrt(eta) - m.shear_per_temperature * (temperature - 300);
}
double hardened(const Material& m, double p) {
  return std::min(m.yield_stress * std::pow(1 + m.strain_factor * p, m.hardening_exponent), m.yield_limit);
}

class SteinbergGuinan : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Materials, SteinbergGuinan,
                         testing::Values("copper-steinberg-guinan", "aluminium-6061-t6-steinberg-guinan"),
                         [](const auto& info) { return std::string(info.param).substr(0, 6); });

/// Shear without a change of volume heats, and heat makes pressure, P = gamma0 rho0 e. Of the angle g:
///   e' = q / (sqrt(3) rho0),   q' = sqrt(3) G - 3 G p',   q = sigma_Y(p, e, P) where it flows
/// By steps of half the size, each solved for p' on the surface.
TEST_P(SteinbergGuinan, FollowsItsFlowStressInShear) {
  const Material m = mpm::named_material(GetParam());
  const double total = 0.4;
  Driven point(m);
  const int steps = 200000;
  const double stretch =
      std::expm1(0.5 * total / steps);  // along x, and as much less along y: axes that do not turn
  point.strain({stretch, 0, 0, -stretch / (1 + stretch)}, 1e-12, steps);
  double p = 0, q = 0, e = 0;
  const int fine = 400000;
  const double d = total / fine;
  for (int k = 0; k < fine; ++k) {
    const double middle = e + 0.5 * q * d / (std::sqrt(3.0) * m.reference_density);
    const double f = factor(m, 0, middle, m.gruneisen_gamma * m.reference_density * e);
    const double g = m.shear_modulus() * f, before = q;
    const double trial = q + std::sqrt(3.0) * g * d;
    double low = 0, high = trial / (3 * g);
    if (trial > f * hardened(m, p)) {
      for (int i = 0; i < 50; ++i) {
        const double dp = 0.5 * (low + high);
        (trial - 3 * g * dp > f * hardened(m, p + dp) ? low : high) = dp;
      }
      p += low, q = trial - 3 * g * low;
    } else {
      q = trial;
    }
    e += 0.5 * (before + q) * d / (std::sqrt(3.0) * m.reference_density);
  }
  EXPECT_GT(p, 0.2);
  EXPECT_NEAR(point.own[mpm::own_plastic_strain] / p, 1, 1e-6);
  EXPECT_NEAR(point.mises() / q, 1, 1e-5);
  EXPECT_NEAR(point.energy / e, 1, 1e-5);
}

/// Compressed along all axes: the longitudinal sound is that of the bulk and of G at this pressure and
/// temperature.
TEST_P(SteinbergGuinan, IsStifferUnderPressure) {
  const Material m = mpm::named_material(GetParam());
  Material fluid = m;
  fluid.strength = mpm::StrengthModel::none;
  Driven point(m), liquid(fluid);
  for (Driven* one : {&point, &liquid}) one->strain({-2e-6, 0, 0, -2e-6}, 1e-12, 40000);
  EXPECT_GT(point.pressure, 1e10);
  const double of_shear = (point.longitudinal_square - liquid.longitudinal_square) * m.reference_density /
                          (1 + point.dilation) / (4.0 / 3 * m.shear_modulus());
  EXPECT_NEAR(of_shear / factor(m, point.dilation, point.energy, point.pressure), 1, 2e-3);
  EXPECT_GT(of_shear, 1.2);
  const double f = factor(m, point.dilation, point.energy, point.pressure);
  EXPECT_NEAR(point.mises() / (f * hardened(m, point.own[mpm::own_plastic_strain])), 1, 1e-4);
}

TEST_P(SteinbergGuinan, HasNoStrengthWhereItMelts) {
  const Material m = mpm::named_material(GetParam());
  Driven point(m);
  point.strain({0, 1e-3, 0, 0}, 1e-9, 10);
  EXPECT_GT(point.mises(), 1e7);
  point.energy += 2 * m.specific_heat * m.melting_temperature;
  point.strain({0, 1e-3, 0, 0}, 1e-9, 2);
  EXPECT_EQ(point.mises(), 0);
}

// Turned as a whole by a quarter, the stress is turned and is no other.
TEST_P(SteinbergGuinan, IsObjective) {
  const Material m = mpm::named_material(GetParam());
  Driven point(m);
  point.strain({0, 1e-4, 0, 0}, 1e-9, 300);
  point.strain({0, -1e-4, 0, 0}, 1e-9, 1);  // off the yield surface, which heat moves
  const auto before = point.s;
  const double p = point.own[mpm::own_plastic_strain], mises = point.mises();
  const int steps = 20000;
  const double turn = std::tan(0.25 * 3.14159265358979323846 / steps);  // half of a step's angle
  // dt L whose midpoint rotation is that angle and whose strain is 0: l (1 + l/2)^-1 = W, W_xy = -2 tan
  const double w = 2 * turn, scale = 1 / (1 + 0.25 * w * w);
  const double diagonal = -0.5 * w * w * scale, off = w * scale;
  point.strain({diagonal, -off, off, diagonal}, 1e-9, steps);
  EXPECT_NEAR(point.mises() / mises, 1, 1e-10);
  EXPECT_NEAR(point.own[mpm::own_plastic_strain] / p, 1, 1e-10);
  EXPECT_NEAR(point.s.xx / before.yy, 1, 1e-6);
  EXPECT_NEAR(point.s.xy / -before.xy, 1, 1e-6);
}

// The polynomial that the kernels use, at volumes and energies of shocks up to 100 GPa.
TEST_P(SteinbergGuinan, KnowsItsTemperature) {
  const Material m = mpm::named_material(GetParam());
  const mpm::SteinbergGuinanConstants<double> constants(m);
  const mpm::Temperature temperature(m);
  for (double dilation = -0.45; dilation < 0.25; dilation += 0.05)
    EXPECT_NEAR(constants.cold_temperature(dilation), temperature(dilation, 0), 1e-4 * m.initial_temperature)
        << dilation;
}

}  // namespace
