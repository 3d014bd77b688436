#pragma once
/// Small vectors and tensors of two and of three axes, and the two sign rules of the whole library:
/// stress is positive in tension, pressure is positive in compression.
#include <Eigen/Core>
#include <cmath>
#include <type_traits>

namespace mpm {

template <int axes>
using Vec = Eigen::Matrix<double, axes, 1>;
template <int axes>
using Mat = Eigen::Matrix<double, axes, axes>;  ///< velocity gradient: row = component, column = direction

using Vec2 = Vec<2>;
using Vec3 = Vec<3>;
using Mat2 = Mat<2>;
using Mat3 = Mat<3>;

/// A symmetric tensor of plane strain and of axial symmetry: the in-plane part and zz.
struct PlaneTensor {
  double xx = 0, yy = 0, zz = 0, xy = 0;
};

/// A symmetric tensor of three axes.
struct FullTensor {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

template <int axes>
using Tensor = std::conditional_t<axes == 2, PlaneTensor, FullTensor>;

inline PlaneTensor operator*(double k, const PlaneTensor& t) {
  return {k * t.xx, k * t.yy, k * t.zz, k * t.xy};
}
inline FullTensor operator*(double k, const FullTensor& t) {
  return {k * t.xx, k * t.yy, k * t.zz, k * t.xy, k * t.xz, k * t.yz};
}

/// t + mean 1
inline PlaneTensor plus_mean(const PlaneTensor& t, double mean) {
  return {t.xx + mean, t.yy + mean, t.zz + mean, t.xy};
}
inline FullTensor plus_mean(const FullTensor& t, double mean) {
  return {t.xx + mean, t.yy + mean, t.zz + mean, t.xy, t.xz, t.yz};
}

/// a : b
inline double contract(const PlaneTensor& a, const PlaneTensor& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy);
}
inline double contract(const FullTensor& a, const FullTensor& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

/// sqrt(3/2 s : s) of a deviator s.
template <class T>
double von_mises(const T& deviator) {
  return std::sqrt(1.5 * contract(deviator, deviator));
}

/// t g, along the axes of the grid
inline Vec2 product(const PlaneTensor& t, const Vec2& g) {
  return {t.xx * g.x() + t.xy * g.y(), t.xy * g.x() + t.yy * g.y()};
}
inline Vec3 product(const FullTensor& t, const Vec3& g) {
  return {t.xx * g.x() + t.xy * g.y() + t.xz * g.z(), t.xy * g.x() + t.yy * g.y() + t.yz * g.z(),
          t.xz * g.x() + t.yz * g.y() + t.zz * g.z()};
}

}  // namespace mpm
