#pragma once
#include <array>

#include "libmpm/verification/exact/neo_hookean.hpp"

namespace mpm::verification::exact {

/// The axis-aligned manufactured solution (axis_aligned.hpp) of three axes: standing waves in the unit cube
/// between six frictionless walls,
///   u_i = w_i A sin(pi X_i) sin(c pi t),  w = (1, -1, 1/2),  c = sqrt(E/rho0),
/// under the body force, with F_i = 1 + du_i/dX_i and J = F_x F_y F_z,
///   rho0 b_i = pi^2 u_i [ lambda (1 - ln J)/F_i^2 + mu (1 + 1/F_i^2) - E ].
/// Lengths in units of the cube's edge, 1 m. Valid for pi A < 1. Checked by
/// tests/verification/exact/standing_waves_test.cpp: force = acceleration - div of the strain energy's
/// stress.
struct CubeWaves {
  using Point = std::array<double, 3>;  ///< x, y, z

  NeoHookean solid;
  double amplitude;  ///< A [m]

  double period() const;                                   ///< 2/c [s]
  Point position(const Point& initial, double t) const;    ///< [m]
  Point velocity(const Point& initial, double t) const;    ///< [m/s]
  Point body_force(const Point& initial, double t) const;  ///< b [N/kg]
};

/// The same in axial symmetry, in the cylinder of radius and height 1 between frictionless walls:
///   u_r = A sin(pi R) sin(c pi t),  u_z = -A sin(pi Z) sin(c pi t);
/// with F_r = 1 + du_r/dR, F_t = 1 + u_r/R, F_z = 1 + du_z/dZ, J = F_r F_t F_z and the first Piola-Kirchhoff
/// stress P_i = lambda ln J / F_i + mu (F_i - 1/F_i),
///   rho0 b_r = -pi^2 E u_r - dP_r/dR - (P_r - P_t)/R,   rho0 b_z = -pi^2 E u_z - dP_z/dZ.
/// Checked as CubeWaves.
struct CylinderWaves {
  using Point = std::array<double, 2>;  ///< r, z

  NeoHookean solid;
  double amplitude;  ///< A [m]

  double period() const;                                   ///< 2/c [s]
  Point position(const Point& initial, double t) const;    ///< [m]
  Point velocity(const Point& initial, double t) const;    ///< [m/s]
  Point body_force(const Point& initial, double t) const;  ///< b [N/kg], R > 0
};

}  // namespace mpm::verification::exact
