#pragma once
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "libmpm/core/state_column.hpp"

namespace mpm {

/// How pressure behaves once the material is expanded (rho < rho0).
enum class Tension {
  polynomial,  ///< the polynomial goes on, up to tenfold (the paper has no failure: walls part numerically)
  linear,      ///< P = C mu without the energy term
  cutoff,      ///< the polynomial, but never below minus the spall strength
};

/// The measure of plastic strain that a hardening modulus is given in.
enum class HardeningMeasure {
  norm,        ///< sigma_Y = sigma_Y0 + E_h ||e^p||, ||e|| = sqrt(e:e) [Xu2007, eq. 4]: H = sqrt(3/2) E_h
  equivalent,  ///< per unit of equivalent plastic strain: H = E_h
  tangent,     ///< uniaxial tangent modulus: H = E E_h / (E - E_h)
};

/// What relates stress to motion.
enum class MaterialLaw {
  solid,        ///< an equation of state and a hypoelastic, perhaps plastic deviator: solid.hpp
  neo_hookean,  ///< elastic at any strain, without heat: neo_hookean.hpp
};

/// What pressure follows from, in a solid or a fluid.
enum class EquationOfState {
  mie_grueneisen,  ///< on a linear Us-Up Hugoniot: eos/mie_grueneisen.hpp
  stiffened_gas,   ///< eos/stiffened_gas.hpp
  tait,            ///< of the density alone: eos/tait.hpp
};

/// What the deviator follows from.
enum class StrengthModel {
  von_mises,         ///< with linear hardening: strength/j2.hpp
  johnson_cook,      ///< strength/johnson_cook.hpp
  steinberg_guinan,  ///< strength/steinberg_guinan.hpp
  none,              ///< a fluid: there is no deviator
};

/// Everything that a scene says about its material. SI units. Plain data; kernels build their own from it.
struct Material {
  std::string name = "aluminium";
  MaterialLaw law = MaterialLaw::solid;
  EquationOfState eos = EquationOfState::mie_grueneisen;
  StrengthModel strength = StrengthModel::von_mises;
  double reference_density = 0;  ///< rho0 [kg/m^3]
  double youngs_modulus = 0;     ///< E [Pa]
  double poissons_ratio = 0;     ///< nu [1]
  double yield_stress = 0;       ///< sigma_Y0 [Pa]; infinite: elastic
  double hardening_modulus = 0;  ///< [Pa], see hardening_measure
  HardeningMeasure hardening_measure = HardeningMeasure::norm;
  double kinematic_fraction = 0;   ///< share of the hardening that moves the yield surface, 0 ... 1 [1]
  double bulk_sound_speed = 0;     ///< c0 of Us = c0 + lambda Up [m/s]
  double hugoniot_slope = 0;       ///< lambda [1]
  double gruneisen_gamma = 0;      ///< gamma0 [1]; gamma rho = gamma0 rho0
  double specific_heat = 0;        ///< c_v [J/kg/K]
  double initial_temperature = 0;  ///< T0 [K]
  double pressure_limit = 0;       ///< upper end of the validity of the equation of state [Pa]
  Tension tension = Tension::polynomial;
  double spall_strength = 0;  ///< [Pa], positive; used by Tension::cutoff only
  /// Equivalent plastic strain at which the material loses its deviator and its tension [1]; infinite: never.
  double failure_strain = std::numeric_limits<double>::infinity();
  // Of the stiffened gas.
  double adiabatic_index = 0;      ///< gamma [1], > 1
  double stiffening_pressure = 0;  ///< P_inf [Pa]
  // Of Tait.
  double tait_pressure = 0;  ///< B [Pa]
  double tait_exponent = 0;  ///< n [1]
  // Of Steinberg-Guinan; Y0 is yield_stress, n hardening_exponent, T_melt0 melting_temperature.
  double strain_factor = 0;          ///< beta [1]
  double yield_limit = 0;            ///< Y_max [Pa]
  double shear_per_pressure = 0;     ///< A = G'_P / G0 [1/Pa]
  double shear_per_temperature = 0;  ///< B = -G'_T / G0 [1/K]
  double melting_gamma_fall = 0;     ///< a [1]
  // Of Johnson-Cook; A is yield_stress, the lowest temperature initial_temperature.
  double strain_hardening = 0;       ///< B [Pa]
  double hardening_exponent = 0;     ///< n [1]
  double rate_hardening = 0;         ///< C [1]
  double reference_strain_rate = 0;  ///< [1/s]
  double softening_exponent = 0;     ///< m [1]
  double melting_temperature = 0;    ///< [K]

  /// A stiffened gas without stiffness may be compressed and expanded as far as one likes.
  bool is_ideal_gas() const { return eos == EquationOfState::stiffened_gas && stiffening_pressure == 0; }
  bool fails() const { return std::isfinite(failure_strain); }
  /// Whether hardening moves the yield surface: only then there is a back stress.
  bool hardens_kinematically() const {
    return strength == StrengthModel::von_mises && std::isfinite(yield_stress) && kinematic_fraction > 0 &&
           hardening_modulus > 0;
  }
  double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }  ///< G [Pa]
  double lame_lambda() const {
    return youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
  }                                                ///< [Pa]
  double hardening_per_equivalent_strain() const;  ///< H [Pa]
};

/// Whether there is a model of it: not every strength goes with every equation of state and tension.
bool has_model(const Material&);
/// Longitudinal [m/s].
double sound_speed_at_rest(const Material&);
/// Of the shock that takes material at rest to this particle speed [m/s]: by the Hugoniot of the equation of
/// state; of a material without one the longitudinal sound speed.
double shock_speed(const Material&, double particle_speed);
/// dP/de at the density of rest, where P = 0 at e = 0 [kg/m^3]; 0 of a material without heat.
double pressure_per_energy(const Material&);
/// What the model of the material keeps of a particle.
std::span<const StateColumn> state_columns(const Material&);

/// The named materials (named.cpp). Throws std::out_of_range for a name that is not in material_names().
Material named_material(std::string_view name);
std::span<const std::string_view> material_names();

}  // namespace mpm
