#pragma once
/// The shape functions of shape/, for a pack of particles.
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

/// Of the hoop, see HoopShape in shape/shape.hpp.
template <class Real, bool has_hoop>
struct HoopWeights {};
template <class Real>
struct HoopWeights<Real, true> {
  Pack<Real> hoop[3];
};

/// Weights and slopes of a pack on the three nodes per axis of each of its particles.
template <class Real, class Space>
struct PackWeights : HoopWeights<Real, Space::has_hoop> {
  Pack<Real> value[Space::axes][3], slope[Space::axes][3];
};

/// The lines of nodes along x in a stencil: one for each row, of three axes one for each slice of each row.
template <int axes>
inline constexpr int lines = axes == 3 ? 9 : 3;

/// d: distance from the nearest node, -1/2 ... 1/2.
template <class Real>
MPM_INLINE void bspline2_axis(Pack<Real> d, Pack<Real>* value, Pack<Real>* slope) {
  const Pack<Real> left = d - Real(0.5), right = d + Real(0.5);
  value[0] = Real(0.5) * left * left;
  value[1] = Real(0.75) - d * d;
  value[2] = Real(0.5) * right * right;
  slope[0] = left;
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

/// BSpline2::hoop, from the weights of the same axis. d: distance from the nearest node, -1/2 ... 1/2.
template <class Real>
MPM_INLINE void bspline2_hoop(Pack<Real> d, const Pack<Real>* value, Pack<Real> half, Pack<Real>* hoop) {
  const Pack<Real> inside = Real(0.25) - d * d, square = half * half;
  const Pack<Real> bend =
      Real(0.5) * square * inside * inside / (Real(1.0 / 30) + Real(7.0 / 15) * square * square);
  hoop[0] = value[0] + bend, hoop[1] = value[1] - 2 * bend, hoop[2] = value[2] + bend;
}

/// Gimp::hoop; d: distance from the nearest node, -1/2 ... 1/2.
template <class Real>
MPM_INLINE void gimp_hoop(Pack<Real> d, Pack<Real> half, Pack<Real>* hoop) {
  const Pack<Real> l = smaller(half, all<Real>(0.5));
  const auto hat = [](Pack<Real> x) __attribute__((always_inline)) {
    return larger(1 - larger(x, -x), Pack<Real>{});
  };
  hoop[0] = Real(0.5) * (hat(1 + d + l) + hat(1 + d - l));
  hoop[2] = Real(0.5) * (hat(1 - d + l) + hat(1 - d - l));
  hoop[1] = 1 - (hoop[0] + hoop[2]);
}

}  // namespace mpm::fast::MPM_ISA
