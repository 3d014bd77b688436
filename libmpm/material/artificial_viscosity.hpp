#pragma once

namespace mpm {

/// Viscous pressure that spreads a shock over a few cells of size h and heats by its work:
///   q = rho h |theta| (q1 c + q2 h |theta|)   where theta = tr D < 0, else 0      [Pa]
/// Source: von Neumann & Richtmyer 1950, J. Appl. Phys. 21, 232 (quadratic); Landshoff 1955, LA-1930
/// (linear). Too small a q2 leaves the pressure right and the deviator wrong: see tests/verification/.
struct ArtificialViscosity {
  double linear;     ///< q1 [1]
  double quadratic;  ///< q2 [1]
  double length;     ///< h [m]

  /// Speed that viscosity adds to the signal, q / (rho h |theta|) [m/s]; 0 in expansion.
  double speed(double theta, double sound_speed) const {
    return theta < 0 ? linear * sound_speed - quadratic * length * theta : 0;
  }
  double pressure(double density, double theta, double sound_speed) const {
    return theta < 0 ? -density * length * theta * speed(theta, sound_speed) : 0;
  }
};

}  // namespace mpm
