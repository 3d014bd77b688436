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
  template <int axes>
  static void start(BasicParticles<axes>&) {}
  /// The velocity that a particle brings to a node [m/s].
  template <int axes>
  static Vec<axes> brought(const BasicParticles<axes>& ps, std::size_t p, const Vec<axes>& /*offset*/) {
    return ps.velocity[p];
  }

  /// Sums over the nodes of one particle.
  template <int axes>
  struct Sums {
    Vec<axes> acceleration = Vec<axes>::Zero();
    double square = 0;
    Sums(const BasicParticles<axes>&, std::size_t, double /*dt*/) {}
    /// offset: from the particle to the node [m]; zero unless `affine`.
    void add(const BasicNode<axes>& n, double w, const Vec<axes>& /*offset*/) {
      acceleration += w * n.acceleration;
      square += w * n.acceleration.squaredNorm();
    }
    double heat(double dt) const { return 0.5 * dt * dt * (square - acceleration.squaredNorm()); }
  };
  /// Changes the particle's velocity. Returns the kinetic energy that the way over the grid has cost, which
  /// stays as heat [J/kg].
  template <int axes>
  double give(const Sums<axes>& s, BasicParticles<axes>& ps, std::size_t p, double dt) const {
    ps.velocity[p] += dt * s.acceleration;
    return s.heat(dt);
  }
};

}  // namespace mpm
