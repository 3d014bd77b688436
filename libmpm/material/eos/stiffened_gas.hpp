#pragma once
#include <cmath>
#include <limits>

#include "libmpm/material/model.hpp"
#include "libmpm/material/row.hpp"

namespace mpm {

/// Stiffened gas, for liquids; with P_inf = 0 an ideal gas, whose pressure at rest, at e = 0, is 0:
///   P = (gamma - 1) rho e + gamma P_inf mu,   mu = rho/rho0 - 1      [Pa]
///   c^2 = gamma (P + P_inf) / rho
/// e counts from the state at rest, where P = 0: with the energy e + gamma P_inf / ((gamma - 1) rho0) it is
/// P = (gamma - 1) rho e - gamma P_inf. Source: Harlow & Amsden 1971, LA-4700; Le Metayer, Massoni, Saurel
/// 2004, Int. J. Thermal Sci. 43, 265. Tension is cut off at minus the spall strength with Tension::cutoff;
/// otherwise it ends at -P_inf, where the sound speed vanishes. Checked by tests/libmpm/fluid_test.cpp.
template <class Real>
struct StiffenedGas {
  Real rho0, inverse_rho0;
  Real gamma;           ///< [1]
  Real less_one;        ///< gamma - 1
  Real stiffness;       ///< gamma P_inf [Pa]
  Real least_square;    ///< a lower bound of c^2 for the viscosity and the step [m^2/s^2]
  Real pressure_floor;  ///< [Pa]
  Real pressure_limit;  ///< [Pa]
  Real least, most;     ///< of J - 1: an ideal gas knows no ends, a millionfold expansion is far enough

  explicit StiffenedGas(const Material& m)
      : rho0(static_cast<Real>(m.reference_density)),
        inverse_rho0(static_cast<Real>(1 / m.reference_density)),
        gamma(static_cast<Real>(m.adiabatic_index)),
        less_one(static_cast<Real>(m.adiabatic_index - 1)),
        stiffness(static_cast<Real>(m.adiabatic_index * m.stiffening_pressure)),
        least_square(static_cast<Real>(1e-3 * sound_square_at_rest(m))),
        pressure_floor(
            static_cast<Real>(m.tension == Tension::cutoff ? -m.spall_strength : -m.stiffening_pressure)),
        pressure_limit(static_cast<Real>(m.pressure_limit)),
        least(static_cast<Real>(m.is_ideal_gas() ? -1 : least_dilation)),
        most(static_cast<Real>(m.is_ideal_gas() ? 1e6 : most_dilation)) {}
  static bool fits(const Material& m) {
    return m.eos == EquationOfState::stiffened_gas && m.tension != Tension::linear;
  }
  static double sound_square_at_rest(const Material& m) {
    return m.adiabatic_index * m.stiffening_pressure / m.reference_density;
  }
  MPM_INLINE Validity<Real> validity() const { return {least, most, pressure_limit}; }

  template <class N>
  MPM_INLINE LinearResponse<N> response(N dilation, N compression, N p) const {
    const N volume = inverse_rho0 * (1 + dilation);
    const N square = (gamma * p + stiffness) * volume;
    return {{stiffness * compression, (less_one * rho0) * (1 + compression)},
            Number<N>::larger(square, Number<N>::all(least_square))};
  }
  template <class N>
  MPM_INLINE N implicit(N, N theta) const {
    return (Real(0.5) * less_one) * theta;
  }
  template <class N>
  MPM_INLINE N held(N p) const {
    return Number<N>::larger(p, Number<N>::all(pressure_floor));
  }
};

inline constexpr MaterialUse eos_is_stiffened_gas{
    "eos = \"stiffened-gas\"",
    [](const Material& m) { return m.law == MaterialLaw::solid && m.eos == EquationOfState::stiffened_gas; }};
inline constexpr MaterialRow stiffened_gas_rows[] = {
    {"adiabatic_index", "1", "adiabatic_index", "gamma of the stiffened gas", Range::non_negative,
     &Material::adiabatic_index, eos_is_stiffened_gas, "", Section::material, 0.0},
    {"stiffening_pressure", "Pa", "stiffening_pressure_Pa", "P_inf of the stiffened gas; 0: an ideal gas",
     Range::non_negative, &Material::stiffening_pressure, eos_is_stiffened_gas, "", Section::material, 0.0},
};

}  // namespace mpm
