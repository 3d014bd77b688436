#pragma once
/// Numbers side by side. The kernels are written once, for a fixed number of lanes, and compiled once for
/// each instruction set: the translation unit says which by MPM_ISA, the namespace that keeps them apart.
/// Lanes are summed in an order that does not depend on the instruction set, and nothing is contracted, so
/// all of them give the same bits.
///
/// Kernel headers use no function of another library: a copy of it that was compiled for AVX2 might be the
/// one that the linker keeps for everybody.
#include <cstddef>
#include <cstdint>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#ifndef MPM_ISA
#define MPM_ISA baseline
#endif
#define MPM_INLINE inline __attribute__((always_inline))

namespace mpm::fast::MPM_ISA {

/// Pack: the same quantity of `width` particles. Quad: four quantities of one particle or node.
template <class Real>
struct Lanes;

template <>
struct Lanes<double> {
  typedef double Pack __attribute__((vector_size(32)));
  typedef double Quad __attribute__((vector_size(32)));
  typedef std::int64_t Mask __attribute__((vector_size(32)));
  typedef std::int32_t Index __attribute__((vector_size(16)));
  static constexpr int width = 4;
};

template <class Real>
using Pack = typename Lanes<Real>::Pack;
template <class Real>
using Quad = typename Lanes<Real>::Quad;

using PackD = Pack<double>;

template <class Real>
MPM_INLINE Pack<Real> all(Real v) {
  return v - Pack<Real>{};  // a broadcast; exact
}
template <class Real>
MPM_INLINE Quad<Real> quad(Real v) {
  return Quad<Real>{v, v, v, v};
}

/// The same number in all lanes, from memory.
template <class Real>
MPM_INLINE Quad<Real> repeat(const Real* from) {
  return quad<Real>(*from);
}
#if defined(__AVX__)
template <>
MPM_INLINE Quad<double> repeat(const double* from) {
  return (Quad<double>)_mm256_broadcast_sd(from);  // GCC 12 makes three instructions of the general form
}
MPM_INLINE PackD square_root(PackD a) { return (PackD)_mm256_sqrt_pd((__m256d)a); }
/// The larger one; b where either is not a number.
MPM_INLINE PackD larger(PackD a, PackD b) { return (PackD)_mm256_max_pd((__m256d)a, (__m256d)b); }
MPM_INLINE PackD smaller(PackD a, PackD b) { return (PackD)_mm256_min_pd((__m256d)a, (__m256d)b); }
#else
MPM_INLINE PackD square_root(PackD a) {
  for (int k = 0; k < 4; ++k) a[k] = __builtin_sqrt(a[k]);
  return a;
}
MPM_INLINE PackD larger(PackD a, PackD b) { return a > b ? a : b; }
MPM_INLINE PackD smaller(PackD a, PackD b) { return a < b ? a : b; }
#endif
#if defined(__AVX__)
MPM_INLINE bool any(Lanes<double>::Mask m) { return _mm256_movemask_pd((__m256d)m) != 0; }
#else
MPM_INLINE bool any(Lanes<double>::Mask m) { return (m[0] | m[1] | m[2] | m[3]) != 0; }
#endif
MPM_INLINE PackD magnitude(PackD a) { return (PackD)((Lanes<double>::Mask)a & INT64_MAX); }

/// Four consecutive numbers from anywhere.
template <class Real>
MPM_INLINE Quad<Real> load_quad(const Real* from) {
  typedef Real Unaligned __attribute__((vector_size(4 * sizeof(Real)), aligned(sizeof(Real)), may_alias));
  return *reinterpret_cast<const Unaligned*>(from);
}
template <class Real>
MPM_INLINE void store_quad(Real* to, Quad<Real> v) {
  typedef Real Unaligned __attribute__((vector_size(4 * sizeof(Real)), aligned(sizeof(Real)), may_alias));
  *reinterpret_cast<Unaligned*>(to) = v;
}

/// Rows of four quantities, one row a particle, `stride` rows apart, to one pack a quantity; and back.
MPM_INLINE void transpose_in(const PackD* rows, int stride, PackD& a, PackD& b, PackD& c, PackD& d) {
  const PackD r0 = rows[0], r1 = rows[stride], r2 = rows[2 * stride], r3 = rows[3 * stride];
  const PackD ac01 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6),
              bd01 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const PackD ac23 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6),
              bd23 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  a = __builtin_shufflevector(ac01, ac23, 0, 1, 4, 5);
  b = __builtin_shufflevector(bd01, bd23, 0, 1, 4, 5);
  c = __builtin_shufflevector(ac01, ac23, 2, 3, 6, 7);
  d = __builtin_shufflevector(bd01, bd23, 2, 3, 6, 7);
}
MPM_INLINE void transpose_out(PackD a, PackD b, PackD c, PackD d, PackD* rows, int stride) {
  const PackD packs[] = {a, b, c, d};
  transpose_in(packs, 1, rows[0], rows[stride], rows[2 * stride], rows[3 * stride]);
}

}  // namespace mpm::fast::MPM_ISA
