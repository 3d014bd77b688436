#include "libmpm/verification/exact/neo_hookean.hpp"

#include <cmath>

namespace mpm::verification::exact {

NeoHookean NeoHookean::of(double density, double youngs_modulus, double poissons_ratio) {
  return {density, youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
          youngs_modulus / (2 * (1 + poissons_ratio))};
}

double NeoHookean::youngs_modulus() const { return mu * (3 * lambda + 2 * mu) / (lambda + mu); }

double NeoHookean::longitudinal_speed() const { return std::sqrt((lambda + 2 * mu) / density); }

double NeoHookean::strain_energy(double jacobian, double trace) const {
  const double log_jacobian = std::log(jacobian);
  return lambda * log_jacobian * log_jacobian / 2 - mu * log_jacobian + mu * trace / 2;
}

}  // namespace mpm::verification::exact
