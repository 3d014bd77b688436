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

  PlaneTensor& operator+=(const PlaneTensor& o) {
    xx += o.xx, yy += o.yy, zz += o.zz, xy += o.xy;
    return *this;
  }
};

inline PlaneTensor operator*(double k, const PlaneTensor& t) {
  return {k * t.xx, k * t.yy, k * t.zz, k * t.xy};
}
inline PlaneTensor operator+(const PlaneTensor& a, const PlaneTensor& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy};
}
inline PlaneTensor operator-(const PlaneTensor& a, const PlaneTensor& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy};
}

/// a : b
inline double contract(const PlaneTensor& a, const PlaneTensor& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy);
}

/// The symmetric part of a gradient; zz = 0 in plane strain.
inline PlaneTensor symmetric(const Mat2& l) { return {l(0, 0), l(1, 1), 0, 0.5 * (l(0, 1) + l(1, 0))}; }

/// Deviator of a tensor.
inline PlaneTensor deviator(const PlaneTensor& t) {
  const double mean = (t.xx + t.yy + t.zz) / 3;
  return {t.xx - mean, t.yy - mean, t.zz - mean, t.xy};
}

/// A rotation by an angle given through its cosine and sine.
struct Rotation {
  double c = 1, s = 0;

  /// The rotation of the midpoint rule over a spin increment w = (W_yx) dt: exact in length for any w.
  /// Source: Hughes & Winget 1980, Int. J. Numer. Meth. Engng 15, 1862.
  static Rotation of_spin(double w) {
    const double a = 0.5 * w, d = 1 + a * a;
    return {(1 - a * a) / d, 2 * a / d};
  }

  /// R t R^T
  PlaneTensor operator()(const PlaneTensor& t) const {
    const double cc = c * c, ss = s * s, cs = c * s;
    return {cc * t.xx + ss * t.yy - 2 * cs * t.xy, ss * t.xx + cc * t.yy + 2 * cs * t.xy, t.zz,
            cs * (t.xx - t.yy) + (cc - ss) * t.xy};
  }
};

}  // namespace mpm
