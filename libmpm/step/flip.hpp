#pragma once
#include "libmpm/core/grid.hpp"

namespace mpm {

/// What a transfer gives a particle: a change of its velocity, and the kinetic energy that the way over the
/// grid costs, which stays as heat.
struct Given {
  Vec2 velocity;  ///< [m/s]
  double heat;    ///< >= 0 [J/kg]
};

/// FLIP: particles take the acceleration of the grid, v_p += dt a_p, a_p = sum w_ip a_i. It does not carry
/// back the variance of the acceleration over the particle's nodes:
///   heat = (dt^2/2) (sum w_ip |a_i|^2 - |a_p|^2)
/// Source: Brackbill & Ruppel 1986, J. Comput. Phys. 65, 314.
struct Flip {
  /// Sums over the nodes of one particle.
  struct Sums {
    Vec2 acceleration = Vec2::Zero();
    double square = 0;
    void add(const Node& n, double w, const Vec2& /*own_velocity*/, double /*dt*/) {
      acceleration += w * n.acceleration;
      square += w * n.acceleration.squaredNorm();
    }
  };
  Given given(const Sums& s, const Vec2& /*own_velocity*/, double dt) const {
    return {dt * s.acceleration, 0.5 * dt * dt * (s.square - s.acceleration.squaredNorm())};
  }
};

}  // namespace mpm
