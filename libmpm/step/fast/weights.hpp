#pragma once
/// The shape functions of shape/, for a pack of particles.
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

/// Weights and slopes of a pack on the three nodes an axis of each of its particles.
template <class Real>
struct PackWeights {
  Pack<Real> x[3], slope_x[3], y[3], slope_y[3];
  std::int32_t first[Lanes<Real>::width];  ///< index of the lower left node
};

template <class Real>
MPM_INLINE void bspline2_axis(Pack<Real> d, Pack<Real>* value, Pack<Real>* slope) {
  const Pack<Real> left = Real(0.5) - d, right = Real(0.5) + d;
  value[0] = Real(0.5) * left * left;
  value[1] = Real(0.75) - d * d;
  value[2] = Real(0.5) * right * right;
  slope[0] = -left;
  slope[1] = Real(-2) * d;
  slope[2] = right;
}

/// A neighbour at distance d on the left; see Gimp::side. `inverse` is 1/(2 l).
template <class Real>
MPM_INLINE void gimp_side(Pack<Real> d, Pack<Real> l, Pack<Real> inverse, Pack<Real>& value,
                          Pack<Real>& slope) {
  const Pack<Real> reach = larger(1 + l - d, Pack<Real>{});
  const Pack<Real> scaled = reach * inverse;
  const auto curved = d >= 1 - l;
  value = curved ? Real(0.5) * reach * scaled : 1 - d;
  slope = curved ? -scaled : all<Real>(-1);
}

template <class Real>
MPM_INLINE void gimp_axis(Pack<Real> d, Pack<Real> half, Pack<Real>* value, Pack<Real>* slope) {
  const Pack<Real> l = smaller(half, all<Real>(0.5));
  const Pack<Real> inverse = Real(0.5) / l;
  gimp_side<Real>(1 + d, l, inverse, value[0], slope[0]);
  gimp_side<Real>(1 - d, l, inverse, value[2], slope[2]);
  slope[2] = -slope[2];
  value[1] = 1 - (value[0] + value[2]);
  slope[1] = -(slope[0] + slope[2]);
}

/// Where particles may be: their stencils lie within the nodes.
template <class Real>
struct Bounds {
  Pack<Real> low, high_x, high_y;
};

/// Weights of a pack at (x, y); returns a mask of lanes that left the grid (their stencil is moved into it).
template <class Real, bool gimp>
MPM_INLINE typename Lanes<Real>::Mask weigh(Pack<Real> x, Pack<Real> y, Pack<Real> half_x, Pack<Real> half_y,
                                            const Bounds<Real>& bounds, Real stride, PackWeights<Real>& w) {
  const Pack<Real> inside_x = smaller(larger(x, bounds.low), bounds.high_x);
  const Pack<Real> inside_y = smaller(larger(y, bounds.low), bounds.high_y);
  using Index = typename Lanes<Real>::Index;
  // truncation is floor, since xi + 3/2 > 0; node nearest to xi = that minus 1
  const Pack<Real> middle_x =
      __builtin_convertvector(__builtin_convertvector(inside_x + Real(1.5), Index), Pack<Real>) - 1;
  const Pack<Real> middle_y =
      __builtin_convertvector(__builtin_convertvector(inside_y + Real(1.5), Index), Pack<Real>) - 1;
  const Index first = __builtin_convertvector(middle_y * stride + middle_x, Index);
  *reinterpret_cast<Index*>(w.first) = first;
  if constexpr (gimp) {
    gimp_axis<Real>(inside_x - middle_x, half_x, w.x, w.slope_x);
    gimp_axis<Real>(inside_y - middle_y, half_y, w.y, w.slope_y);
  } else {
    bspline2_axis<Real>(inside_x - middle_x, w.x, w.slope_x);
    bspline2_axis<Real>(inside_y - middle_y, w.y, w.slope_y);
  }
  return (inside_x != x) | (inside_y != y);
}

}  // namespace mpm::fast::MPM_ISA
