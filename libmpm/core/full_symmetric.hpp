#pragma once
/// The tensors of symmetric.hpp with all of their components, for three axes, and the functions that models
/// use them by.
#include "libmpm/core/symmetric.hpp"

namespace mpm {

/// dt L of three axes.
template <class N>
struct FullGradient {
  N xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

/// A symmetric tensor.
template <class N>
struct FullSymmetric {
  N xx, yy, zz, xy, xz, yz;
};

/// A strain over a step.
template <class N>
struct FullIncrement {
  N xx, yy, zz, xy, xz, yz;
};

/// A tensor without trace: zz = -(xx + yy).
template <class N>
struct FullDeviator {
  N xx, yy, xy, xz, yz;
};

/// A rotation R, row by row.
template <class N>
struct FullRotation {
  N xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

template <class N>
MPM_INLINE N trace(const FullIncrement<N>& e) {
  return e.xx + e.yy + e.zz;
}

template <class N>
MPM_INLINE N trace(const FullSymmetric<N>& a) {
  return a.xx + a.yy + a.zz;
}
template <class N>
MPM_INLINE N norm_square(const FullSymmetric<N>& a) {
  return a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz);
}
template <class N>
MPM_INLINE FullDeviator<N> deviator(const FullSymmetric<N>& a) {
  const N mean = trace(a) * Scalar<N>(1.0 / 3.0);
  return {a.xx - mean, a.yy - mean, a.xy, a.xz, a.yz};
}
template <class N>
MPM_INLINE FullDeviator<N> deviator(const FullIncrement<N>& e) {
  const N mean = trace(e) * Scalar<N>(1.0 / 3.0);
  return {e.xx - mean, e.yy - mean, e.xy, e.xz, e.yz};
}

template <class N>
MPM_INLINE FullDeviator<N> operator-(const FullDeviator<N>& a, const FullDeviator<N>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
}

/// a + k b
template <class N, class K>
MPM_INLINE FullDeviator<N> sum(const FullDeviator<N>& a, K k, const FullDeviator<N>& b) {
  return {a.xx + k * b.xx, a.yy + k * b.yy, a.xy + k * b.xy, a.xz + k * b.xz, a.yz + k * b.yz};
}

template <class N>
MPM_INLINE FullDeviator<N> scaled(N k, const FullDeviator<N>& a) {
  return {k * a.xx, k * a.yy, k * a.xy, k * a.xz, k * a.yz};
}

/// a : a / 2
template <class N>
MPM_INLINE N second_invariant(const FullDeviator<N>& a) {
  return a.xx * a.xx + a.yy * a.yy + a.xx * a.yy + a.xy * a.xy + a.xz * a.xz + a.yz * a.yz;
}

/// a : b
template <class N>
MPM_INLINE N contract(const FullDeviator<N>& a, const FullDeviator<N>& b) {
  return 2 * (a.xx * b.xx + a.yy * b.yy) + a.xx * b.yy + a.yy * b.xx +
         2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}
template <class N>
MPM_INLINE N contract(const FullDeviator<N>& a, const FullIncrement<N>& e) {
  return a.xx * (e.xx - e.zz) + a.yy * (e.yy - e.zz) + 2 * (a.xy * e.xy + a.xz * e.xz + a.yz * e.yz);
}

/// R a R^T
template <class N>
MPM_INLINE FullDeviator<N> rotated(const FullRotation<N>& r, const FullDeviator<N>& a) {
  const N a_zz = -(a.xx + a.yy);
  // rows of R a
  const N xx = r.xx * a.xx + r.xy * a.xy + r.xz * a.xz, xy = r.xx * a.xy + r.xy * a.yy + r.xz * a.yz,
          xz = r.xx * a.xz + r.xy * a.yz + r.xz * a_zz;
  const N yx = r.yx * a.xx + r.yy * a.xy + r.yz * a.xz, yy = r.yx * a.xy + r.yy * a.yy + r.yz * a.yz,
          yz = r.yx * a.xz + r.yy * a.yz + r.yz * a_zz;
  return {xx * r.xx + xy * r.xy + xz * r.xz, yx * r.yx + yy * r.yy + yz * r.yz,
          xx * r.yx + xy * r.yy + xz * r.yz, xx * r.zx + xy * r.zy + xz * r.zz,
          yx * r.zx + yy * r.zy + yz * r.zz};
}

/// det(1 + l) - 1, without the 1, so that small dilations keep their digits.
template <class N>
MPM_INLINE N growth_of(const FullGradient<N>& l) {
  const N x = l.yy * l.zz - l.yz * l.zy, y = l.yz * l.zx - l.yx * l.zz, z = l.yx * l.zy - l.yy * l.zx;
  const N minors = x + (l.xx * l.zz - l.xz * l.zx) + (l.xx * l.yy - l.xy * l.yx);
  return (l.xx + l.yy + l.zz) + minors + (l.xx * x + l.xy * y + l.xz * z);
}

/// l (1 + l/2)^-1: the gradient of the displacement, seen from the middle of the step.
template <class N>
MPM_INLINE FullGradient<N> midpoint(const FullGradient<N>& l) {
  using R = Scalar<N>;
  const R half = R(0.5);
  const N a = 1 + half * l.xx, b = half * l.xy, c = half * l.xz;
  const N d = half * l.yx, e = 1 + half * l.yy, f = half * l.yz;
  const N g = half * l.zx, h = half * l.zy, i = 1 + half * l.zz;
  // the adjugate of 1 + l/2
  const N xx = e * i - f * h, xy = c * h - b * i, xz = b * f - c * e;
  const N yx = f * g - d * i, yy = a * i - c * g, yz = c * d - a * f;
  const N zx = d * h - e * g, zy = b * g - a * h, zz = a * e - b * d;
  const N inverse = 1 / (a * xx + b * yx + c * zx);
  return {
      (l.xx * xx + l.xy * yx + l.xz * zx) * inverse, (l.xx * xy + l.xy * yy + l.xz * zy) * inverse,
      (l.xx * xz + l.xy * yz + l.xz * zz) * inverse, (l.yx * xx + l.yy * yx + l.yz * zx) * inverse,
      (l.yx * xy + l.yy * yy + l.yz * zy) * inverse, (l.yx * xz + l.yy * yz + l.yz * zz) * inverse,
      (l.zx * xx + l.zy * yx + l.zz * zx) * inverse, (l.zx * xy + l.zy * yy + l.zz * zy) * inverse,
      (l.zx * xz + l.zy * yz + l.zz * zz) * inverse,
  };
}

template <class N>
MPM_INLINE FullIncrement<N> symmetric_part(const FullGradient<N>& l) {
  const Scalar<N> half(0.5);
  return {l.xx, l.yy, l.zz, half * (l.xy + l.yx), half * (l.xz + l.zx), half * (l.yz + l.zy)};
}

/// The rotation of the spin W, the antisymmetric part of l, by the midpoint rule (Hughes & Winget 1980):
///   R = (1 - W/2)^-1 (1 + W/2) = 1 + 2 (T + T^2) / (1 + t.t),   T = W/2, t its axis.
template <class N>
MPM_INLINE FullRotation<N> rotation_of_spin(const FullGradient<N>& l) {
  const Scalar<N> quarter(0.25);
  const N x = quarter * (l.zy - l.yz), y = quarter * (l.xz - l.zx), z = quarter * (l.yx - l.xy);
  const N xx = x * x, yy = y * y, zz = z * z, xy = x * y, xz = x * z, yz = y * z;
  const N twice = 2 / (1 + (xx + yy + zz));
  return {1 - twice * (yy + zz), twice * (xy - z),      twice * (xz + y),
          twice * (xy + z),      1 - twice * (xx + zz), twice * (yz - x),
          twice * (xz - y),      twice * (yz + x),      1 - twice * (xx + yy)};
}

/// (1 + l) (1 + a) (1 + l)^T - 1, so that small strains keep their digits.
template <class N>
MPM_INLINE FullSymmetric<N> carried(const FullGradient<N>& l, const FullSymmetric<N>& a) {
  // l (1 + a)
  const N xx = l.xx * (1 + a.xx) + l.xy * a.xy + l.xz * a.xz,
          xy = l.xx * a.xy + l.xy * (1 + a.yy) + l.xz * a.yz,
          xz = l.xx * a.xz + l.xy * a.yz + l.xz * (1 + a.zz);
  const N yx = l.yx * (1 + a.xx) + l.yy * a.xy + l.yz * a.xz,
          yy = l.yx * a.xy + l.yy * (1 + a.yy) + l.yz * a.yz,
          yz = l.yx * a.xz + l.yy * a.yz + l.yz * (1 + a.zz);
  const N zx = l.zx * (1 + a.xx) + l.zy * a.xy + l.zz * a.xz,
          zy = l.zx * a.xy + l.zy * (1 + a.yy) + l.zz * a.yz,
          zz = l.zx * a.xz + l.zy * a.yz + l.zz * (1 + a.zz);
  return {a.xx + (2 * xx + (xx * l.xx + xy * l.xy + xz * l.xz)),
          a.yy + (2 * yy + (yx * l.yx + yy * l.yy + yz * l.yz)),
          a.zz + (2 * zz + (zx * l.zx + zy * l.zy + zz * l.zz)),
          a.xy + ((xy + yx) + (xx * l.yx + xy * l.yy + xz * l.yz)),
          a.xz + ((xz + zx) + (xx * l.zx + xy * l.zy + xz * l.zz)),
          a.yz + ((yz + zy) + (yx * l.zx + yy * l.zy + yz * l.zz))};
}

/// Components of a tensor, one after the other, as models keep them in columns of their own.
template <class N>
MPM_INLINE void load(const N* from, FullSymmetric<N>& a) {
  a = {from[0], from[1], from[2], from[3], from[4], from[5]};
}
template <class N>
MPM_INLINE void store(const FullSymmetric<N>& a, N* to) {
  to[0] = a.xx, to[1] = a.yy, to[2] = a.zz, to[3] = a.xy, to[4] = a.xz, to[5] = a.yz;
}
template <class N>
MPM_INLINE void load(const N* from, FullDeviator<N>& a) {
  a = {from[0], from[1], from[2], from[3], from[4]};
}
template <class N>
MPM_INLINE void store(const FullDeviator<N>& a, N* to) {
  to[0] = a.xx, to[1] = a.yy, to[2] = a.xy, to[3] = a.xz, to[4] = a.yz;
}

}  // namespace mpm
