#pragma once
/// Symmetric tensors over any number (core/number.hpp), whose components xz and yz are 0; with all
/// components: full_symmetric.hpp. A model uses them by the functions below and asks for no component, so
/// that it does not depend on the space.
#include "libmpm/core/number.hpp"

namespace mpm {

/// dt L: the gradient of the displacement over a step; row = component, column = direction.
template <class N>
struct Gradient {
  N xx, xy, yx, yy;
};

/// ... and dt v_r / r along the hoop.
template <class N>
struct AxialGradient {
  Gradient<N> plane;
  N hoop;
};

/// A symmetric tensor.
template <class N>
struct Symmetric {
  N xx, yy, zz, xy;
};

/// A strain over a step, with zz = 0.
template <class N>
struct PlaneIncrement {
  N xx, yy, xy;
};

/// A strain over a step, with zz along the hoop.
template <class N>
struct AxialIncrement {
  N xx, yy, xy;
  N zz{};
};

/// A tensor without trace: zz = -(xx + yy).
template <class N>
struct Deviator {
  N xx, yy, xy;
};

/// A rotation, by the cosine and the sine of its angle.
template <class N>
struct PlaneRotation {
  N cosine, sine;
};

template <class N>
MPM_INLINE N trace(const PlaneIncrement<N>& e) {
  return e.xx + e.yy;
}
template <class N>
MPM_INLINE N trace(const AxialIncrement<N>& e) {
  return e.xx + e.yy + e.zz;
}

template <class N>
MPM_INLINE N trace(const Symmetric<N>& a) {
  return a.xx + a.yy + a.zz;
}
template <class N>
MPM_INLINE N norm_square(const Symmetric<N>& a) {
  return a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy);
}
template <class N>
MPM_INLINE Deviator<N> deviator(const Symmetric<N>& a) {
  const N mean = trace(a) * Scalar<N>(1.0 / 3.0);
  return {a.xx - mean, a.yy - mean, a.xy};
}
template <class N>
MPM_INLINE Deviator<N> deviator(const PlaneIncrement<N>& e) {
  const N mean = (e.xx + e.yy) * Scalar<N>(1.0 / 3.0);
  return {e.xx - mean, e.yy - mean, e.xy};
}
template <class N>
MPM_INLINE Deviator<N> deviator(const AxialIncrement<N>& e) {
  const N mean = trace(e) * Scalar<N>(1.0 / 3.0);
  return {e.xx - mean, e.yy - mean, e.xy};
}

template <class N>
MPM_INLINE Deviator<N> operator-(const Deviator<N>& a, const Deviator<N>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
}

/// a + k b
template <class N, class K>
MPM_INLINE Deviator<N> sum(const Deviator<N>& a, K k, const Deviator<N>& b) {
  return {a.xx + k * b.xx, a.yy + k * b.yy, a.xy + k * b.xy};
}

template <class N>
MPM_INLINE Deviator<N> scaled(N k, const Deviator<N>& a) {
  return {k * a.xx, k * a.yy, k * a.xy};
}

/// a : a / 2
template <class N>
MPM_INLINE N second_invariant(const Deviator<N>& a) {
  return a.xx * a.xx + a.yy * a.yy + a.xx * a.yy + a.xy * a.xy;
}

/// a : b
template <class N>
MPM_INLINE N contract(const Deviator<N>& a, const Deviator<N>& b) {
  return 2 * (a.xx * b.xx + a.yy * b.yy) + a.xx * b.yy + a.yy * b.xx + 2 * (a.xy * b.xy);
}
template <class N>
MPM_INLINE N contract(const Deviator<N>& a, const PlaneIncrement<N>& e) {
  return a.xx * e.xx + a.yy * e.yy + 2 * (a.xy * e.xy);
}
template <class N>
MPM_INLINE N contract(const Deviator<N>& a, const AxialIncrement<N>& e) {
  return a.xx * (e.xx - e.zz) + a.yy * (e.yy - e.zz) + 2 * (a.xy * e.xy);
}

/// R a R^T
template <class N>
MPM_INLINE Deviator<N> rotated(const PlaneRotation<N>& r, const Deviator<N>& a) {
  const N cc = r.cosine * r.cosine, ss = r.sine * r.sine, cs = r.cosine * r.sine, cs2 = cs + cs;
  const N double_cosine = cc - ss;
  const N in_plane = a.xx + a.yy, xx = cc * a.xx + ss * a.yy - cs2 * a.xy;
  return {xx, in_plane - xx, cs * (a.xx - a.yy) + double_cosine * a.xy};
}

/// (1 + l) (1 + a) (1 + l)^T - 1, so that small strains keep their digits.
template <class N>
MPM_INLINE Symmetric<N> carried(const Gradient<N>& l, const Symmetric<N>& a) {
  // l (1 + a)
  const N xx = l.xx * (1 + a.xx) + l.xy * a.xy, xy = l.xx * a.xy + l.xy * (1 + a.yy);
  const N yx = l.yx * (1 + a.xx) + l.yy * a.xy, yy = l.yx * a.xy + l.yy * (1 + a.yy);
  return {a.xx + (2 * xx + (xx * l.xx + xy * l.xy)), a.yy + (2 * yy + (yx * l.yx + yy * l.yy)), a.zz,
          a.xy + ((xy + yx) + (xx * l.yx + xy * l.yy))};
}
template <class N>
MPM_INLINE Symmetric<N> carried(const AxialGradient<N>& l, const Symmetric<N>& a) {
  Symmetric<N> b = carried(l.plane, a);
  const N zz = l.hoop * (1 + a.zz);
  b.zz = a.zz + (2 * zz + zz * l.hoop);
  return b;
}

/// Components of a tensor, one after the other, as models keep them in columns of their own.
template <class N>
MPM_INLINE void load(const N* from, Symmetric<N>& a) {
  a = {from[0], from[1], from[2], from[3]};
}
template <class N>
MPM_INLINE void store(const Symmetric<N>& a, N* to) {
  to[0] = a.xx, to[1] = a.yy, to[2] = a.zz, to[3] = a.xy;
}
template <class N>
MPM_INLINE void load(const N* from, Deviator<N>& a) {
  a = {from[0], from[1], from[2]};
}
template <class N>
MPM_INLINE void store(const Deviator<N>& a, N* to) {
  to[0] = a.xx, to[1] = a.yy, to[2] = a.xy;
}

}  // namespace mpm
