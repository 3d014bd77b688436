#pragma once
#include <algorithm>
#include <cmath>

#include "libmpm/shape/linear.hpp"

namespace mpm {

/// The weights of one particle with a domain of four corners: each corner has a stencil of its own.
struct CornerStencil {
  std::array<ProductStencil<2>, 4> corner;
  std::array<Vec2, 4> slope;  ///< average over the domain of the gradient of each corner's function [1/m]

  /// Calls visit(node, weight, gradient); a node that several corners see is visited as often.
  template <class AnyGrid, class Visit>
  void for_each(AnyGrid& grid, Visit visit) const {
    for (int c = 0; c < 4; ++c)
      corner[c].for_each(grid,
                         [&](auto& node, double w, const Vec2&) { visit(node, 0.25 * w, w * slope[c]); });
  }
};

/// Convected particle domain interpolation: the hat functions at the corners x_c of the particle's
/// parallelogram x +- a +- b, interpolated bilinearly over it and averaged:
///   S_i = 1/4 sum_c N_i(x_c),   grad S_i = sum_c N_i(x_c) grad(c),
///   grad(c) = (+-1) (b_y, -b_x) / (4 a x b) + (+-1) (-a_y, a_x) / (4 a x b)
/// Source: Sadeghirad, Brannon, Burghardt 2011, Int. J. Numer. Meth. Engng 86, 1435. The half edges a, b
/// follow the whole deformation of the particle, so that domains go on tiling the body in stretch and shear.
///
/// Guard: where the body is torn, or closes on itself, domains turn into needles that tie together what lies
/// far apart, and the run breaks down. A domain whose longest half axis passes `longest` becomes a square of
/// the particle's volume again; with 1 instead of 3/4 of a cell the strong collapse (500 m/s, wall 2 um) does
/// not hold.
struct Cpdi {
  static constexpr int reach = 3;
  static constexpr double longest = 0.75;  ///< half axis [cells]

  /// Makes domains of the half sizes, where there are none yet.
  static void start(Particles& particles) {
    if (particles.domain.size() == particles.size()) return;
    particles.domain.clear();
    for (const Vec2& half : particles.half_size) particles.domain.emplace_back(half.asDiagonal());
  }

  static CornerStencil stencil(const Grid& grid, const Particles& particles, std::size_t p) {
    const Mat2& d = particles.domain[p];
    const Vec2 a = d.col(0), b = d.col(1);
    const double inverse = 0.25 / cross(d);
    const Vec2 along_a(b.y() * inverse, -b.x() * inverse), along_b(-a.y() * inverse, a.x() * inverse);
    CornerStencil s;
    for (int c = 0; c < 4; ++c) {
      const double i = c % 2 == 0 ? -1 : 1, j = c < 2 ? -1 : 1;
      s.corner[c] = stencil_at<Linear, 2>(grid, particles.position[p] + i * a + j * b, Vec2::Zero());
      s.slope[c] = i * along_a + j * along_b;
    }
    return s;
  }

  static void follow(const Grid& grid, Particles& particles, std::size_t p, const Mat2& growth) {
    Mat2& d = particles.domain[p];
    const Mat2 increment = growth * d;
    d += increment;
    const double limit = longest * grid.cell().minCoeff();
    if (!(cross(d) > 0) || half_axis(d) > limit)
      d = std::min(0.5 * std::sqrt(particles.volume(p)), limit) * Mat2::Identity();
  }

 private:
  static double cross(const Mat2& d) { return d(0, 0) * d(1, 1) - d(1, 0) * d(0, 1); }
  /// The larger singular value.
  static double half_axis(const Mat2& d) {
    const double square = d.squaredNorm(), area = cross(d);
    return std::sqrt(0.5 * (square + std::sqrt(std::max(square * square - 4 * area * area, 0.0))));
  }
};
static_assert(ShapeFunctions<Cpdi>);

}  // namespace mpm
