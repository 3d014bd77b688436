#pragma once
#include <algorithm>
#include <cmath>

#include "libmpm/shape/shape.hpp"

namespace mpm {

/// Generalised interpolation: the hat function averaged over the particle's domain of half-size l (cells),
/// l <= 1/2. With r = xi - node:
///   S = 1 - (r^2 + l^2) / (2 l)        for |r| <= l,
///   S = 1 - |r|                        for l <= |r| <= 1 - l,
///   S = (1 + l - |r|)^2 / (4 l)        for 1 - l <= |r| <= 1 + l.
/// Source: Bardenhagen & Kober 2004, CMES 5, 477. l = 1/2 is the quadratic B-spline.
/// The domain follows the diagonal stretch of the particle ("updated domains"); one that is wider than a cell
/// is treated as one cell wide.
struct Gimp {
  static constexpr int reach = 2;
  static constexpr double largest_half_size = 0.5;  ///< cells; three nodes per axis reach no further

  static Weights evaluate(double xi, double half) {
    half = std::min(half, largest_half_size);
    Weights w;
    const int middle = nearest_node(xi);
    const double r = xi - middle;  // -1/2 ... 1/2
    w.first = middle - 1;
    side(1 + r, half, w.value[0], w.slope[0]);
    side(1 - r, half, w.value[2], w.slope[2]);
    w.slope[2] = -w.slope[2];
    w.value[1] = 1 - (w.value[0] + w.value[2]);
    w.slope[1] = -(w.slope[0] + w.slope[2]);
    return w;
  }
  /// The mean of the hat function N at both ends of the extent, with [N] = 2 l S':
  /// [r N] = 2 l (r_p S' + (N(r_p + l) + N(r_p - l)) / 2).
  static std::array<double, 3> hoop(double xi, double half) {
    half = std::min(half, largest_half_size);
    const double r = xi - nearest_node(xi);
    const auto hat = [](double d) { return std::max(1 - std::abs(d), 0.0); };
    const double left = 0.5 * (hat(1 + r + half) + hat(1 + r - half));
    const double right = 0.5 * (hat(1 - r + half) + hat(1 - r - half));
    return {left, 1 - (left + right), right};
  }
  template <int axes>
  static void follow(const BasicGrid<axes>&, BasicParticles<axes>& particles, std::size_t p,
                     const Mat<axes>& growth) {
    for (int k = 0; k < axes; ++k) particles.half_size[p][k] *= 1 + growth(k, k);
  }

 private:
  /// A neighbour at distance d, 1/2 <= d <= 3/2, on the left: value and slope with respect to xi.
  static void side(double d, double l, double& value, double& slope) {
    const double reach = 1 + l - d;
    if (d >= 1 - l && reach > 0) {
      value = reach * reach / (4 * l);
      slope = -reach / (2 * l);
    } else if (reach > 0) {
      value = 1 - d;
      slope = -1;
    } else {
      value = slope = 0;
    }
  }
};
static_assert(ShapeFunctions<Gimp>);

}  // namespace mpm
