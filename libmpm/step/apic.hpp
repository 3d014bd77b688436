#pragma once
#include <limits>

#include "libmpm/core/grid.hpp"
#include "libmpm/core/particles.hpp"

namespace mpm {

/// APIC: a particle takes the velocity of the grid and its gradient, and brings both back: at offset r from
/// the particle it brings v_p + C_p r. With v_i, u_i the grid's velocity after and before the step, r_i the
/// node's offset,
///   v_p = sum w_ip v_i,   B_p = sum w_ip v_i (x) r_i,   D_p = sum w_ip r_i (x) r_i,   C_p = B_p D_p^-1.
/// Of all transfers to one velocity and one gradient this loses least: C_p is the least-squares fit. Angular
/// momentum, sum m_p (x_p x v_p + spin of C_p), is kept to rounding. Kinetic energy of the affine motion is
/// tr(C_p D_p C_p^T)/2 per mass; what neither velocity nor gradient takes is left as heat,
///   sum w_ip |v_p + C_p r_i - u_i|^2 / 2  on the way to the grid, with the old C_p,
///   sum w_ip |v_i - v_p - C_p r_i|^2 / 2  on the way back, with the new one,
/// both never negative, and their sum closes the balance of energy to rounding. Where D_p changes between two
/// steps (all but B-splines) the difference of affine energy goes into the heat too.
/// Source: Jiang, Schroeder, Selle, Teran, Stomakhin 2015, ACM Trans. Graph. 34, 51.
struct Apic {
  static constexpr bool affine = true;
  template <int axes>
  static void start(BasicParticles<axes>& ps) {
    if (ps.affine.size() == ps.size()) return;
    ps.affine.assign(ps.size(), Mat<axes>::Zero());
    ps.affine_energy.assign(ps.size(), 0);
  }
  template <int axes>
  static Vec<axes> brought(const BasicParticles<axes>& ps, std::size_t p, const Vec<axes>& offset) {
    return ps.velocity[p] + ps.affine[p] * offset;
  }

  /// Velocities in here are relative to the particle's old one, which loses no digits.
  template <int axes>
  struct Sums {
    Vec<axes> own_velocity, mean = Vec<axes>::Zero();
    Mat<axes> gradient, moment = Mat<axes>::Zero(), second = Mat<axes>::Zero();  ///< C_p, B_p, D_p
    double dt, square = 0, spread = 0;
    Sums(const BasicParticles<axes>& ps, std::size_t p, double step)
        : own_velocity(ps.velocity[p]), gradient(ps.affine[p]), dt(step) {}
    void add(const BasicNode<axes>& n, double w, const Vec<axes>& r) {
      const Vec<axes> v = n.velocity - own_velocity;
      mean += w * v;
      square += w * v.squaredNorm();
      moment += (w * v) * r.transpose();
      second += (w * r) * r.transpose();
      spread += w * (gradient * r - (v - dt * n.acceleration)).squaredNorm();
    }
  };
  template <int axes>
  double give(const Sums<axes>& s, BasicParticles<axes>& ps, std::size_t p, double /*dt*/) const {
    const double brought = 0.5 * (s.gradient * s.second).cwiseProduct(s.gradient).sum();
    const Mat<axes> fit = s.moment * inverse_or_zero(s.second);
    const double kept = 0.5 * fit.cwiseProduct(s.moment).sum();
    const double left = ps.affine_energy[p] - brought;
    ps.velocity[p] += s.mean;
    ps.affine[p] = fit;
    ps.affine_energy[p] = kept;
    return 0.5 * s.spread + 0.5 * (s.square - s.mean.squaredNorm()) - kept + left;
  }

 private:
  /// A particle with a small domain, right on a node, has no second moment and carries no gradient.
  static Mat2 inverse_or_zero(const Mat2& d) {
    const double determinant = d(0, 0) * d(1, 1) - d(0, 1) * d(1, 0);
    const double trace = d(0, 0) + d(1, 1);
    if (!(determinant > std::numeric_limits<double>::epsilon() * trace * trace)) return Mat2::Zero();
    Mat2 inverse;
    inverse << d(1, 1), -d(0, 1), -d(1, 0), d(0, 0);
    return inverse / determinant;
  }
  static Mat3 inverse_or_zero(const Mat3& d) {
    const Vec3 a = d.col(0), b = d.col(1), c = d.col(2);
    Mat3 inverse;  // the adjugate: rows b x c, c x a, a x b
    inverse << b.y() * c.z() - b.z() * c.y(), b.z() * c.x() - b.x() * c.z(), b.x() * c.y() - b.y() * c.x(),
        c.y() * a.z() - c.z() * a.y(), c.z() * a.x() - c.x() * a.z(), c.x() * a.y() - c.y() * a.x(),
        a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x();
    const double determinant = inverse.row(0).dot(a), trace = d.trace();
    if (!(determinant > std::numeric_limits<double>::epsilon() * trace * trace * trace)) return Mat3::Zero();
    return inverse / determinant;
  }
};

}  // namespace mpm
