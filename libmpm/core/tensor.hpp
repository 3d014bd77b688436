#pragma once
/// Small tensors of plane strain, and the two sign rules of the whole library:
/// stress is positive in tension, pressure is positive in compression.
#include <Eigen/Core>

namespace mpm {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;  ///< velocity gradient: row = component, column = direction

/// A symmetric tensor of plane strain: the in-plane part and zz.
struct PlaneTensor {
  double xx = 0, yy = 0, zz = 0, xy = 0;
};

inline PlaneTensor operator*(double k, const PlaneTensor& t) {
  return {k * t.xx, k * t.yy, k * t.zz, k * t.xy};
}

/// a : b
inline double contract(const PlaneTensor& a, const PlaneTensor& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy);
}

}  // namespace mpm
