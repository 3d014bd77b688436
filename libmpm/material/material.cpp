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

double sound_speed_at_rest(const Material& m) {
  double speed = 0;
  with_model_type<double>(m, [&]<class Model>(std::size_t) { speed = Model::sound_speed_at_rest(m); });
  return speed;
}

double shock_speed(const Material& m, double particle_speed) {
  if (m.law != MaterialLaw::solid) return sound_speed_at_rest(m);
  return m.bulk_sound_speed + m.hugoniot_slope * particle_speed;
}

std::span<const StateColumn> state_columns(const Material& m) {
  std::span<const StateColumn> columns;
  with_model_type<double>(m, [&]<class Model>(std::size_t) { columns = Model::state; });
  return columns;
}

}  // namespace mpm
