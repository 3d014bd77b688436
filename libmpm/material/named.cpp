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
    // Hugoniot: Barker & Hollenbach 1970, J. Appl. Phys. 41, 4208, and Marsh 1980; G, yield stress: Steinberg
    {"pmma", 1186, 2.32e9, 420e6, 2598, 1.516, 0.97, 1466, 300, 20e9},
    // nearly iron. Hugoniot: Selected Hugoniots, LA-4167-MS, 1969; its strength stands below
    {"steel-1006", 7896, 81.8e9, 350e6, 4569, 1.49, 2.17, 452, 300, 150e9},
};

/// Strength of Johnson & Cook 1983, Proc. 7th Int. Symp. Ballistics, 541, tables 1 and 2; the rest is that of
/// the named material `like`.
struct NamedJohnsonCook {
  std::string_view name, like;
  double a, b, n, c, m, melting_temperature;  ///< Pa, Pa, 1, 1, 1, K
};
constexpr NamedJohnsonCook of_johnson_cook[] = {
    {"copper-johnson-cook", "copper", 90e6, 292e6, 0.31, 0.025, 1.09, 1356},
    {"steel-1006", "steel-1006", 350e6, 275e6, 0.36, 0.022, 1.00, 1811},
};

/// Steinberg-Guinan; the rest is that of the named material `like`, which has its G0 and Y0 from the same
/// table. Steinberg 1996, UCRL-MA-106439, as the input files of the Uintah framework give them
/// (SCG_CopperOFHC.xml, SCG_Aluminum6061-T6.xml); the model: Steinberg, Cochran, Guinan 1980, J. Appl. Phys.
/// 51, 1498.
struct NamedSteinbergGuinan {
  std::string_view name, like;
  double beta, n, limit, per_pressure, per_temperature, melting_temperature,
      a;  ///< 1, 1, Pa, 1/Pa, 1/K, K, 1
};
constexpr NamedSteinbergGuinan of_steinberg_guinan[] = {
    {"copper-steinberg-guinan", "copper", 36, 0.45, 640e6, 2.83e-11, 3.77e-4, 1790, 1.5},
    {"aluminium-6061-t6-steinberg-guinan", "aluminium-6061-t6", 125, 0.10, 680e6, 6.52e-11, 6.16e-4, 1220,
     1.5},
};

/// Water of 20 C by Tait's equation as Cole writes it, with n = 7.15 (R. H. Cole 1948, Underwater Explosions,
/// Princeton); B = rho0 c0^2 / n of the sound speed 1482 m/s. It cavitates.
Material water_of_tait() {
  Material m;
  m.name = "water-tait";
  m.eos = EquationOfState::tait;
  m.strength = StrengthModel::none;
  m.reference_density = 998.2;
  m.tait_exponent = 7.15;
  m.tait_pressure = 998.2 * 1482 * 1482 / 7.15;
  m.specific_heat = 4184;
  m.initial_temperature = 293;
  m.pressure_limit = 2.5e9;  // Cole: up to about 25 kbar
  m.tension = Tension::cutoff;
  return m;
}

/// Liquid water, a stiffened gas: O. Le Metayer, J. Massoni, R. Saurel 2004, Int. J. Thermal Sci. 43, 265;
/// its tension is cut off at 0: it cavitates.
Material water() {
  Material m;
  m.name = "water";
  m.eos = EquationOfState::stiffened_gas;
  m.strength = StrengthModel::none;
  m.reference_density = 1000;
  m.adiabatic_index = 2.35;
  m.stiffening_pressure = 1e9;
  m.specific_heat = 1816;
  m.initial_temperature = 300;
  m.pressure_limit = 10e9;
  m.tension = Tension::cutoff;
  return m;
}

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

Material from(const NamedJohnsonCook& row, Material m) {
  m.name = row.name;
  m.strength = StrengthModel::johnson_cook;
  m.yield_stress = row.a;
  m.strain_hardening = row.b;
  m.hardening_exponent = row.n;
  m.rate_hardening = row.c;
  m.reference_strain_rate = 1;
  m.softening_exponent = row.m;
  m.melting_temperature = row.melting_temperature;
  return m;
}

Material from(const NamedSteinbergGuinan& row) {
  Material m = named_material(row.like);
  m.name = row.name;
  m.strength = StrengthModel::steinberg_guinan;
  m.strain_factor = row.beta;
  m.hardening_exponent = row.n;
  m.yield_limit = row.limit;
  m.shear_per_pressure = row.per_pressure;
  m.shear_per_temperature = row.per_temperature;
  m.melting_temperature = row.melting_temperature;
  m.melting_gamma_fall = row.a;
  return m;
}

constexpr auto names = std::to_array<std::string_view>(
    {"aluminium", "aluminium-6061-t6", "copper", "tungsten", "tantalum", "pmma", "steel-1006",
     "copper-johnson-cook", "water", "copper-steinberg-guinan", "aluminium-6061-t6-steinberg-guinan",
     "water-tait"});

}  // namespace

Material named_material(std::string_view name) {
  if (name == "aluminium") return aluminium();
  if (name == "water-tait") return water_of_tait();
  const auto sg = std::ranges::find(of_steinberg_guinan, name, &NamedSteinbergGuinan::name);
  if (sg != std::end(of_steinberg_guinan)) return from(*sg);
  if (name == "water") return water();
  const auto jc = std::ranges::find(of_johnson_cook, name, &NamedJohnsonCook::name);
  const std::string_view constants = jc == std::end(of_johnson_cook) ? name : jc->like;
  const auto row = std::ranges::find(by_shear_modulus, constants, &Named::name);
  if (row == std::end(by_shear_modulus))
    throw std::out_of_range("no material named '" + std::string(name) + "'");
  return jc == std::end(of_johnson_cook) ? from(*row) : from(*jc, from(*row));
}

std::span<const std::string_view> material_names() { return names; }

}  // namespace mpm
