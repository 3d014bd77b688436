// The named materials: constants as data, each row with its sources.
#include <algorithm>
#include <array>
#include <stdexcept>

#include "libmpm/material/material.hpp"

namespace mpm {
namespace {

struct Named {
  std::string_view name;
  double density, shear_modulus, yield_stress;        ///< kg/m^3, Pa, Pa
  double sound_speed, slope, gamma;                   ///< c0 [m/s], lambda, gamma0
  double specific_heat, temperature, pressure_limit;  ///< J/kg/K, K, Pa
};

/// Density, G, yield stress, c0, lambda, gamma0 and c_v: D. J. Steinberg, Equation of state and strength
/// properties of selected materials, UCRL-MA-106439, 1996; the c_v of tantalum: CRC Handbook of Chemistry and
/// Physics. Its hardening and its dependence on pressure and temperature are left out: the yield stress is
/// the initial one. Pressure limit: a round number well within the shock data that these straight lines were
/// fitted to (S. P. Marsh, LASL shock Hugoniot data, 1980; Mitchell & Nellis 1981, J. Appl. Phys. 52, 3363).
constexpr Named by_shear_modulus[] = {
    {"aluminium-6061-t6", 2703, 27.6e9, 290e6, 5240, 1.40, 1.97, 885, 300, 150e9},
    {"copper", 8930, 47.7e9, 120e6, 3940, 1.489, 2.02, 383, 300, 200e9},  // OFHC, half hard
    {"tungsten", 19300, 160e9, 2200e6, 4030, 1.237, 1.67, 129, 300, 200e9},
    {"tantalum", 16690, 69e9, 770e6, 3410, 1.20, 1.67, 140, 300, 200e9},
};

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

/// E and nu that make G together with the bulk modulus rho0 c0^2.
Material from(const Named& row) {
  const double g = row.shear_modulus, k = row.density * row.sound_speed * row.sound_speed;
  Material m;
  m.name = row.name;
  m.reference_density = row.density;
  m.youngs_modulus = 9 * k * g / (3 * k + g);
  m.poissons_ratio = (3 * k - 2 * g) / (2 * (3 * k + g));
  m.yield_stress = row.yield_stress;
  m.hardening_measure = HardeningMeasure::norm;
  m.bulk_sound_speed = row.sound_speed;
  m.hugoniot_slope = row.slope;
  m.gruneisen_gamma = row.gamma;
  m.pressure_limit = row.pressure_limit;
  m.specific_heat = row.specific_heat;
  m.initial_temperature = row.temperature;
  return m;
}

constexpr auto names = [] {
  std::array<std::string_view, 1 + std::size(by_shear_modulus)> all{"aluminium"};
  std::ranges::transform(by_shear_modulus, all.begin() + 1, &Named::name);
  return all;
}();

}  // namespace

Material named_material(std::string_view name) {
  if (name == names[0]) return aluminium();
  const auto row = std::ranges::find(by_shear_modulus, name, &Named::name);
  if (row == std::end(by_shear_modulus))
    throw std::out_of_range("no material named '" + std::string(name) + "'");
  return from(*row);
}

std::span<const std::string_view> material_names() { return names; }

}  // namespace mpm
