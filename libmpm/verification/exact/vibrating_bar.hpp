#pragma once
#include <cmath>
#include <numbers>

namespace mpm::verification::exact {

/// A thin elastic bar, fixed at x = 0 and free at x = L, in its first mode: v(x, 0) = v0 sin(pi x/2L) from
/// the unstressed state. The textbook's longitudinal vibration, linear elasticity: v0 is small against
/// sqrt(E/rho).
///   w = (pi/2L) sqrt(E/rho),   v_cm = (2 v0/pi) cos(w t),   u_cm = (2 v0/(pi w)) sin(w t)
struct VibratingBar {
  double length;          ///< L [m]
  double youngs_modulus;  ///< E [Pa]
  double density;         ///< rho [kg/m^3]
  double speed;           ///< v0 [m/s]

  double frequency() const {  ///< w [rad/s]
    return std::numbers::pi / (2 * length) * std::sqrt(youngs_modulus / density);
  }
  double period() const { return 2 * std::numbers::pi / frequency(); }  ///< [s]
  double initial_velocity(double x) const {                             ///< [m/s]
    return speed * std::sin(std::numbers::pi * x / (2 * length));
  }
  double largest_mean_velocity() const { return 2 * speed / std::numbers::pi; }  ///< of v_cm [m/s]
  double mean_velocity(double t) const {                                         ///< v_cm [m/s]
    return largest_mean_velocity() * std::cos(frequency() * t);
  }
};

}  // namespace mpm::verification::exact
