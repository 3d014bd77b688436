#pragma once
#include "libmpm/verification/exact/neo_hookean.hpp"
#include "libmpm/verification/exact/vector.hpp"

namespace mpm::verification::exact {

/// Axis-aligned manufactured solution: standing waves in the unit square between four frictionless walls,
///   u_x = A sin(pi X) sin(c pi t),  u_y = A sin(pi Y) sin(c pi t + pi),  c = sqrt(E/rho0),
/// under the body force, with F_ii = 1 + du_i/dX_i and J = F_xx F_yy,
///   rho0 b_i = pi^2 u_i [ lambda (1 - ln J)/F_ii^2 + mu (1 + 1/F_ii^2) - E ].
/// Lengths in units of the square's edge, 1 m. Valid for pi A < 1.
/// Source: Kamojjala, Brannon, Sadeghirad, Guilkey 2015, Eng. Comput. 31, 193.
/// Checked by tests/verification/exact/manufactured_test.cpp: force = acceleration - div of the strain
/// energy's stress.
struct AxisAligned {
  NeoHookean solid;
  double amplitude;  ///< A [m]

  double period() const;                              ///< 2/c [s]
  Vector position(Vector initial, double t) const;    ///< [m]
  Vector velocity(Vector initial, double t) const;    ///< [m/s]
  Vector body_force(Vector initial, double t) const;  ///< b [N/kg]
};

}  // namespace mpm::verification::exact
