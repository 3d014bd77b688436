#include "libmpm/material/material.hpp"

#include <cmath>

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

}  // namespace mpm
