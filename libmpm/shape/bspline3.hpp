#pragma once
#include "libmpm/shape/shape.hpp"

namespace mpm {

/// Cubic B-spline: with d the distance to a node in cells,
///   S = 2/3 - d^2 + d^3/2    for d <= 1,
///   S = (2 - d)^3 / 6        for 1 <= d <= 2.
/// Source: Steffen, Kirby, Berzins 2008, Int. J. Numer. Meth. Engng 76, 922. At walls: see BSpline2.
struct BSpline3 {
  static constexpr int reach = 2;

  static WeightsOn<4> evaluate(double xi, double /*half*/) {
    WeightsOn<4> w;
    const int left = static_cast<int>(xi + 2) - 2;  // floor, for xi > -2
    const double t = xi - left, u = 1 - t;
    w.first = left - 1;
    w.value = {u * u * u / 6, 2.0 / 3 - t * t + 0.5 * t * t * t, 2.0 / 3 - u * u + 0.5 * u * u * u,
               t * t * t / 6};
    w.slope = {-0.5 * u * u, -2 * t + 1.5 * t * t, 2 * u - 1.5 * u * u, 0.5 * t * t};
    return w;
  }
  template <int axes>
  static void follow(const BasicGrid<axes>&, BasicParticles<axes>&, std::size_t, const Mat<axes>&) {}
};
static_assert(ShapeFunctions<BSpline3>);

}  // namespace mpm
