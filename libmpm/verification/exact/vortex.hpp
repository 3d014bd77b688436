#pragma once
#include "libmpm/verification/exact/neo_hookean.hpp"
#include "libmpm/verification/exact/vector.hpp"

namespace mpm::verification::exact {

/// Generalised vortex: rings of material turn about the origin by alpha = g(t) h(R),
///   g = A (1 - cos(2 pi t/T))/2,   h = 1 - 32 (R-1)^2 + 256 (R-1)^4 on 3/4 < R < 5/4, else 0;   J = 1.
/// Body force in the CURRENT polar basis, subscripts are derivatives:
///   b_r = -R alpha_t^2 + mu R alpha_R^2/rho0,   b_theta = R alpha_tt - mu (R alpha_RR + 3 alpha_R)/rho0.
/// h and its slope are continuous, its second derivative is not: b_theta jumps at R = 3/4 and 5/4.
/// Lengths in units of the middle radius, 1 m.
/// Source: Kamojjala, Brannon, Sadeghirad, Guilkey 2015, Eng. Comput. 31, 193.
/// Checked by tests/verification/exact/manufactured_test.cpp: force = acceleration - div of the strain
/// energy's stress.
struct Vortex {
  NeoHookean solid;
  double amplitude;   ///< A, the largest turn [rad]
  double period = 1;  ///< T [s]

  Vector position(Vector initial, double t) const;    ///< [m]
  Vector velocity(Vector initial, double t) const;    ///< [m/s]
  Vector body_force(Vector initial, double t) const;  ///< b [N/kg]
};

}  // namespace mpm::verification::exact
