#pragma once
#include "libmpm/material/eos/mie_grueneisen.hpp"

namespace mpm {

/// Temperature of the Mie-Grueneisen solid with constant c_v and gamma rho:
///   T = T_s(V) + (e - e_s(V)) / c_v,   T_s = T0 exp(gamma0 eta),   de_s/d(eta) = P(eta, e_s) / rho0
/// where the index s is the isentrope through the state at rest and eta = 1 - rho0/rho = -(J - 1). [K]
/// Source: the Grueneisen relation at constant gamma rho; Zel'dovich & Raizer 1967, ch. XI.
/// Checked against the Hugoniot temperatures by tests/libmpm/material_test.cpp.
struct Temperature {
  MieGrueneisen eos;
  double specific_heat;        ///< c_v [J/kg/K]
  double initial_temperature;  ///< T0 [K]

  double operator()(double dilation, double energy) const;
};

}  // namespace mpm
