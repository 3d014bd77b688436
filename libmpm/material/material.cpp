#include "libmpm/material/material.hpp"

#include <cmath>

#include "libmpm/material/list.hpp"

namespace mpm {

double Material::hardening_per_equivalent_strain() const {
  switch (hardening_measure) {
    case HardeningMeasure::norm:
      return std::sqrt(1.5) * hardening_modulus;
    case HardeningMeasure::equivalent:
      return hardening_modulus;
    case HardeningMeasure::tangent:
      return youngs_modulus * hardening_modulus / (youngs_modulus - hardening_modulus);
  }
  return hardening_modulus;
}

bool has_model(const Material& m) {
  return [&]<class... Models>(ModelList<Models...>) {
    return (Models::fits(m) || ...);
  }(CompiledModels<double>{});
}

double sound_speed_at_rest(const Material& m) {
  double speed = 0;
  with_model_type<double>(m, [&]<class Model>(std::size_t) { speed = Model::sound_speed_at_rest(m); });
  return speed;
}

double shock_speed(const Material& m, double particle_speed) {
  if (m.law != MaterialLaw::solid) return sound_speed_at_rest(m);
  if (m.eos == EquationOfState::stiffened_gas) {
    // mass and momentum with P = (gamma - 1) rho e + gamma P_inf mu: Us is the larger root of
    //   Us^2 - (gamma + 1) / 2 up Us - c0^2 = 0
    const double half = 0.25 * (m.adiabatic_index + 1) * particle_speed;
    return half + std::sqrt(half * half + m.adiabatic_index * m.stiffening_pressure / m.reference_density);
  }
  if (m.eos == EquationOfState::tait) return tait_shock_speed(m, particle_speed);
  return m.bulk_sound_speed + m.hugoniot_slope * particle_speed;
}

double pressure_per_energy(const Material& m) {
  if (m.law != MaterialLaw::solid || m.eos == EquationOfState::tait) return 0;
  const double gamma = m.eos == EquationOfState::stiffened_gas ? m.adiabatic_index - 1 : m.gruneisen_gamma;
  return gamma * m.reference_density;
}

std::span<const StateColumn> state_columns(const Material& m) {
  std::span<const StateColumn> columns;
  with_model_type<double>(m, [&]<class Model>(std::size_t) { columns = Model::state; });
  return columns;
}

}  // namespace mpm
