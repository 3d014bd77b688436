#pragma once
#include "libmpm/step/flip.hpp"

namespace mpm {

/// FLIP with a share f of PIC in every step, which damps what particles carry and the grid cannot see:
///   v_p += dt a_p + f d,   d = sum w_ip u_i - v_p,   u_i = v_i - dt a_i (the grid's velocity before the
///   step)
/// With <.> the mean over the particle's nodes, the heat that this leaves,
///   f <|u - v_p|^2> - f^2/2 |d|^2 + f dt (<u.a> - <u>.<a>) + dt^2/2 (<|a|^2> - |<a>|^2),
/// is that of the sum over all particles, since sum_p m_p w_ip (u_i - v_p) = 0 at every node; and it is not
/// negative for 0 <= f <= 2, as a quadratic form in the fluctuations of u and a over the nodes. So the total
/// energy is kept to rounding. Damping acts like a shear viscosity of about f h^2/(4 dt), first order in the
/// cell. Source of the blend: Stomakhin, Schroeder, Chai, Teran, Selle 2013, ACM Trans. Graph. 32, 102.
struct FlipPic {
  double pic_fraction = 0;  ///< f, a step [1]

  static constexpr bool affine = false;
  template <int axes>
  static void start(BasicParticles<axes>&) {}
  template <int axes>
  static Vec<axes> brought(const BasicParticles<axes>& ps, std::size_t p, const Vec<axes>&) {
    return ps.velocity[p];
  }

  template <int axes>
  struct Sums {
    Flip::Sums<axes> flip;
    Vec<axes> own_velocity, before = Vec<axes>::Zero();
    double dt, spread = 0, mixed = 0;
    Sums(const BasicParticles<axes>& ps, std::size_t p, double step)
        : flip(ps, p, step), own_velocity(ps.velocity[p]), dt(step) {}
    void add(const BasicNode<axes>& n, double w, const Vec<axes>& offset) {
      flip.add(n, w, offset);
      const Vec<axes> u = n.velocity - dt * n.acceleration;
      before += w * u;
      spread += w * (u - own_velocity).squaredNorm();
      mixed += w * u.dot(n.acceleration);
    }
  };
  template <int axes>
  double give(const Sums<axes>& s, BasicParticles<axes>& ps, std::size_t p, double dt) const {
    const double f = pic_fraction;
    const Vec<axes> d = s.before - s.own_velocity;
    ps.velocity[p] += dt * s.flip.acceleration + f * d;
    return s.flip.heat(dt) + f * s.spread - 0.5 * f * f * d.squaredNorm() +
           f * dt * (s.mixed - s.before.dot(s.flip.acceleration));
  }
};

}  // namespace mpm
