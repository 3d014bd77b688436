#pragma once
#include "libmpm/shape/shape.hpp"

namespace mpm {

/// Piecewise linear ("hat") functions: S = 1 - |d|, d the distance to a node in cells. Their slopes jump as a
/// particle crosses from one cell to the next. Source: Sulsky, Chen, Schreyer 1994.
struct Linear {
  static constexpr int reach = 2;

  static WeightsOn<2> evaluate(double xi, double /*half*/) {
    const int first = static_cast<int>(xi + 2) - 2;  // floor, for xi > -2
    const double d = xi - first;
    return {first, {1 - d, d}, {-1, 1}};
  }
  template <int axes>
  static void follow(const BasicGrid<axes>&, BasicParticles<axes>&, std::size_t, const Mat<axes>&) {}
};
static_assert(ShapeFunctions<Linear>);

}  // namespace mpm
