#include "libmpm/material/material.hpp"

#include <cmath>
#include <stdexcept>

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

namespace {
/// [Xu2007, section 3], with E in GPa (the paper prints "Mpa"); c_v and T0 are those of the physics brief.
Material aluminium() {
  Material m;
  m.name = "aluminium";
  m.reference_density = 2700;
  m.youngs_modulus = 69e9;
  m.poissons_ratio = 0.33;
  m.yield_stress = 120e6;
  m.hardening_modulus = 384e6;
  m.hardening_measure = HardeningMeasure::norm;
  m.bulk_sound_speed = 5350;
  m.hugoniot_slope = 1.34;
  m.gruneisen_gamma = 1.96;
  m.pressure_limit = 270e9;
  m.specific_heat = 880;
  m.initial_temperature = 300;
  return m;
}
}  // namespace

Material named_material(std::string_view name) {
  if (name == "aluminium") return aluminium();
  throw std::out_of_range("no material named '" + std::string(name) + "'");
}

std::vector<std::string> material_names() { return {"aluminium"}; }

}  // namespace mpm
