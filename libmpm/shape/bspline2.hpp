#pragma once
#include "libmpm/shape/shape.hpp"

namespace mpm {

/// Quadratic B-spline: with d the distance to a node in cells,
///   S = 3/4 - d^2            for d <= 1/2,
///   S = (3/2 - d)^2 / 2      for 1/2 <= d <= 3/2.
/// Source: Steffen, Kirby, Berzins 2008, Int. J. Numer. Meth. Engng 76, 922.
/// Partition of unity and linear reproduction hold at walls too, since walls are mirrors with ghost nodes.
struct BSpline2 {
  static constexpr int reach = 2;

  static Weights evaluate(double xi, double /*half*/) {
    Weights w;
    const int middle = nearest_node(xi);
    const double d = xi - middle;  // -1/2 ... 1/2
    w.first = middle - 1;
    w.value = {0.5 * (0.5 - d) * (0.5 - d), 0.75 - d * d, 0.5 * (0.5 + d) * (0.5 + d)};
    w.slope = {d - 0.5, -2 * d, d + 0.5};
    return w;
  }
  /// S + c (1, -2, 1) on the three nodes, with
  ///   c(d) = (l^2 / 2) (1/4 - d^2)^2 / (1/30 + 7 l^4 / 15).
  /// Where S is one parabola over the particle, S + (l^2 / 2) (1, -2, 1) is its integral. But that does not
  /// vanish where S does: a node with next to no mass would be driven by a finite force. c is spread so that
  /// it vanishes with S, and sums to the same over the particles nearest to a node: midpoints of an even
  /// number of particles per edge have 1/30 + 7 l^4 / 15 as the mean of (1/4 - d^2)^2.
  static std::array<double, 3> hoop(double xi, double half) {
    const Weights w = evaluate(xi, half);
    const double d = xi - (w.first + 1), inside = 0.25 - d * d, square = half * half;
    const double bend = 0.5 * square * inside * inside / (1.0 / 30 + 7.0 / 15 * square * square);
    return {w.value[0] + bend, w.value[1] - 2 * bend, w.value[2] + bend};
  }
  template <int axes>
  static void follow(const BasicGrid<axes>&, BasicParticles<axes>&, std::size_t, const Mat<axes>&) {}
};
static_assert(ShapeFunctions<BSpline2>);

}  // namespace mpm
