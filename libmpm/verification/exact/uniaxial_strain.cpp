#include "libmpm/verification/exact/uniaxial_strain.hpp"

#include <algorithm>
#include <cmath>

namespace mpm::verification::exact {

UniaxialStrain::UniaxialStrain(const ElasticPlasticSolid& solid, double kinematic_fraction)
    : solid_(solid), kinematic_(kinematic_fraction) {}

UniaxialStrain::UniaxialStrain(const ElasticPlasticSolid& solid, const ImpactState& state)
    : solid_(solid),
      kinematic_(0),
      strain_(std::log(state.density / solid.fluid.density)),
      q_(state.von_mises),
      plastic_strain_(state.equivalent_plastic_strain),
      energy_(state.specific_energy) {}

double UniaxialStrain::density() const { return solid_.fluid.density * std::exp(strain_); }
double UniaxialStrain::pressure() const { return solid_.fluid.pressure(density(), energy_); }
double UniaxialStrain::normal_stress() const { return normal_stress_at(strain_, energy_, q_); }

double UniaxialStrain::normal_stress_at(double strain, double energy, double q) const {
  return solid_.fluid.pressure(solid_.fluid.density * std::exp(strain), energy) + 2 * q / 3;
}

/// Along a smooth piece, on which dq/d_eps = slope: energy, speed and q.
void UniaxialStrain::move(double change, double slope) {
  constexpr double longest = 5e-4;  // of strain: the error is of its fourth power
  const MieGruneisenFluid& fluid = solid_.fluid;
  struct Rate {
    double energy, speed;  ///< per unit of strain
  };
  const auto rate = [&](double strain, double energy, double q) {
    const double rho = fluid.density * std::exp(strain), dv = -1 / rho;  // dV/d_eps
    const double sigma = normal_stress_at(strain, energy, q);
    const double dsigma =
        (fluid.pressure_slope(rho) - fluid.gamma * fluid.density * sigma) * dv + 2 * slope / 3;
    return Rate{-sigma * dv, std::sqrt(-dsigma * dv)};
  };
  const double steps = std::max(1.0, std::ceil(std::abs(change) / longest)), h = change / steps;
  for (int k = 0; k < steps; ++k) {
    const Rate k1 = rate(strain_, energy_, q_);
    const Rate k2 = rate(strain_ + h / 2, energy_ + h / 2 * k1.energy, q_ + h / 2 * slope);
    const Rate k3 = rate(strain_ + h / 2, energy_ + h / 2 * k2.energy, q_ + h / 2 * slope);
    const Rate k4 = rate(strain_ + h, energy_ + h * k3.energy, q_ + h * slope);
    energy_ += h / 6 * (k1.energy + 2 * k2.energy + 2 * k3.energy + k4.energy);
    speed_ += std::abs(h) / 6 * (k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed);
    strain_ += h;
    q_ += h * slope;
  }
}

void UniaxialStrain::strain_to(double strain) {
  const double stiffness = 2 * solid_.shear_modulus;
  const double sign = strain < strain_ ? -1 : 1;
  const double to_yield = std::max(radius() - sign * (q_ - back_), 0.0) / stiffness;
  const double elastic = std::min(std::abs(strain - strain_), to_yield);
  if (elastic > 0) move(sign * elastic, stiffness);
  const double rest = strain - strain_;
  if (!(sign * rest > 0)) return;
  const double flow = stiffness / (3 * solid_.shear_modulus + solid_.hardening);  // dp / |d_eps|
  move(rest, solid_.hardening * flow);
  back_ += kinematic_ * solid_.hardening * flow * rest;
  plastic_strain_ += flow * std::abs(rest);
}

}  // namespace mpm::verification::exact
