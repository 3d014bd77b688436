#include "libmpm/material/eos/temperature.hpp"

#include <cmath>

#include "libmpm/material/eos/tait.hpp"

namespace mpm {

double Temperature::operator()(double dilation, double energy) const {
  if (material.law != MaterialLaw::solid) return material.initial_temperature;
  if (material.eos == EquationOfState::stiffened_gas) {
    const double less_one = material.adiabatic_index - 1, compressed = 1 / (1 + dilation);
    const double growth = std::pow(compressed, less_one);
    const double isentrope = material.stiffening_pressure / material.reference_density *
                             ((growth - 1) / less_one - (1 - 1 / compressed));
    return material.initial_temperature * growth + (energy - isentrope) / material.specific_heat;
  }
  if (material.eos == EquationOfState::tait)
    return material.initial_temperature + (energy - tait_energy(material, dilation)) / material.specific_heat;
  // The isentrope is smooth in eta: 16 Runge-Kutta steps leave less than 1e-8 of e_s up to half the volume.
  constexpr int steps = 16;
  const double d = -dilation / steps;  // step in eta
  const auto slope = [this](double eta, double e) {
    const MieGrueneisen::Line l = eos.line(MieGrueneisen::Volume(-eta));
    return (l.cold + l.thermal * e) / eos.rho0;
  };
  double e = 0;
  for (int k = 0; k < steps; ++k) {
    const double eta = k * d;
    const double k1 = slope(eta, e);
    const double k2 = slope(eta + 0.5 * d, e + 0.5 * d * k1);
    const double k3 = slope(eta + 0.5 * d, e + 0.5 * d * k2);
    const double k4 = slope(eta + d, e + d * k3);
    e += d * (k1 + 2 * (k2 + k3) + k4) / 6;
  }
  return material.initial_temperature * std::exp(-eos.gamma0 * dilation) +
         (energy - e) / material.specific_heat;
}

}  // namespace mpm
