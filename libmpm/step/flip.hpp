#pragma once
#include "libmpm/core/grid.hpp"
#include "libmpm/core/particles.hpp"

namespace mpm {

/// FLIP: particles take the acceleration of the grid, v_p += dt a_p, a_p = sum w_ip a_i. It does not carry
/// back the variance of the acceleration over the particle's nodes:
///   heat = (dt^2/2) (sum w_ip |a_i|^2 - |a_p|^2)
/// Source: Brackbill & Ruppel 1986, J. Comput. Phys. 65, 314.
struct Flip {
  /// Whether what a particle brings to a node depends on where the node is.
  static constexpr bool affine = false;
  static void start(Particles&) {}
  /// The velocity that a particle brings to a node [m/s].
  static Vec2 brought(const Particles& ps, std::size_t p, const Vec2& /*offset*/) { return ps.velocity[p]; }

  /// Sums over the nodes of one particle.
  struct Sums {
    Vec2 acceleration = Vec2::Zero();
    double square = 0;
    Sums(const Particles&, std::size_t, double /*dt*/) {}
    /// offset: from the particle to the node [m]; zero unless `affine`.
    void add(const Node& n, double w, const Vec2& /*offset*/) {
      acceleration += w * n.acceleration;
      square += w * n.acceleration.squaredNorm();
    }
    double heat(double dt) const { return 0.5 * dt * dt * (square - acceleration.squaredNorm()); }
  };
  /// Changes the particle's velocity. Returns the kinetic energy that the way over the grid has cost, which
  /// stays as heat [J/kg].
  double give(const Sums& s, Particles& ps, std::size_t p, double dt) const {
    ps.velocity[p] += dt * s.acceleration;
    return s.heat(dt);
  }
};

}  // namespace mpm
