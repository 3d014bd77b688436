#pragma once
#include "libmpm/material/eos/mie_grueneisen.hpp"

namespace mpm {

/// Temperature of the Mie-Grueneisen solid with constant c_v and gamma rho:
///   T = T_s(V) + (e - e_s(V)) / c_v,   T_s = T0 exp(gamma0 eta),   de_s/d(eta) = P(eta, e_s) / rho0
/// where the index s is the isentrope through the state at rest and eta = 1 - rho0/rho = -(J - 1). [K]
/// Source: the Grueneisen relation at constant gamma rho; Zel'dovich & Raizer 1967, ch. XI.
/// The same of the stiffened gas, whose Gamma = gamma - 1 is constant:
///   T_s = T0 (rho/rho0)^(gamma - 1),   e_s = P_inf / rho0 ((T_s/T0 - 1) / (gamma - 1) - (1 - rho0/rho))
/// Of Tait, whose pressure knows no heat: T_s = T0 at all volumes.
/// A neo-Hookean solid, whose law has no heat, stays at T0.
/// Checked against the Hugoniot temperatures by tests/libmpm/material_test.cpp.
struct Temperature {
  Material material;
  MieGrueneisen eos;

  explicit Temperature(const Material& m) : material(m), eos(m) {}
  double operator()(double dilation, double energy) const;
};

inline constexpr MaterialRow temperature_rows[] = {
    {"specific_heat", "J/kg/K", "specific_heat_J_kg_K", "specific heat at constant volume", Range::positive,
     &Material::specific_heat, law_is_solid},
    {"initial_temperature", "K", "initial_temperature_K", "temperature at rest", Range::non_negative,
     &Material::initial_temperature},
};

}  // namespace mpm
