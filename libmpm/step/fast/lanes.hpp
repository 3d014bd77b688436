#pragma once
/// Numbers side by side. The kernels are written once, for packs of 32 bytes, and compiled once for each
/// instruction set: the translation unit says which by MPM_ISA, the namespace that keeps them apart. Lanes
/// are summed in an order that does not depend on the instruction set. The AVX2 kernels contract a*b + c into
/// one rounding (FMA), the baseline ones cannot: that is all in which their results differ.
///
/// Kernel headers use no function of another library: a copy of it that was compiled for AVX2 might be the
/// one that the linker keeps for everybody.
#include <cstddef>
#include <cstdint>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "libmpm/core/number.hpp"

#ifndef MPM_ISA
#define MPM_ISA baseline
#endif

namespace mpm::fast::MPM_ISA {

/// Pack: the same quantity of `width` particles or nodes.
template <class Real>
struct Lanes;

template <>
struct Lanes<double> {
  typedef double Pack __attribute__((vector_size(32)));
  using Mask = decltype(Pack{} < Pack{});  // of whole numbers; compilers differ in which of 64 bits
  using Whole = Pack;                      ///< numbers of nodes: a double counts them
  static constexpr int width = 4;
  static constexpr Whole numbers = {0, 1, 2, 3};
  static constexpr double round_to_whole = 0x1.8p52;  ///< a + this - this is a whole number
};

template <>
struct Lanes<float> {
  typedef float Pack __attribute__((vector_size(32)));
  using Mask = decltype(Pack{} < Pack{});
  using Whole = Mask;  ///< numbers of nodes: a float counts to 2^24 alone
  static constexpr int width = 8;
  static constexpr Whole numbers = {0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr float round_to_whole = 0x1.8p23F;
};

template <class Real>
using Pack = typename Lanes<Real>::Pack;
template <class Real>
using Mask = typename Lanes<Real>::Mask;
template <class Real>
using Whole = typename Lanes<Real>::Whole;

using PackD = Pack<double>;
using PackF = Pack<float>;

template <class Real>
MPM_INLINE Pack<Real> all(Real v) {
  return v - Pack<Real>{};  // a broadcast; exact
}

/// The same for whole numbers.
template <class Real>
MPM_INLINE Whole<Real> all_whole(std::int32_t v) {
  return static_cast<decltype(Whole<Real>{}[0] + 0)>(v) - Whole<Real>{};
}

#if defined(__AVX__)
MPM_INLINE PackD square_root(PackD a) { return (PackD)_mm256_sqrt_pd((__m256d)a); }
MPM_INLINE PackF square_root(PackF a) { return (PackF)_mm256_sqrt_ps((__m256)a); }
/// The larger one; b where either is not a number.
MPM_INLINE PackD larger(PackD a, PackD b) { return (PackD)_mm256_max_pd((__m256d)a, (__m256d)b); }
MPM_INLINE PackF larger(PackF a, PackF b) { return (PackF)_mm256_max_ps((__m256)a, (__m256)b); }
MPM_INLINE PackD smaller(PackD a, PackD b) { return (PackD)_mm256_min_pd((__m256d)a, (__m256d)b); }
MPM_INLINE PackF smaller(PackF a, PackF b) { return (PackF)_mm256_min_ps((__m256)a, (__m256)b); }
/// Bit l is lane l.
MPM_INLINE int bits(Mask<double> m) { return _mm256_movemask_pd((__m256d)m); }
MPM_INLINE int bits(Mask<float> m) { return _mm256_movemask_ps((__m256)m); }
#else
MPM_INLINE PackD square_root(PackD a) {
  for (int k = 0; k < 4; ++k) a[k] = __builtin_sqrt(a[k]);
  return a;
}
MPM_INLINE PackF square_root(PackF a) {
  for (int k = 0; k < 8; ++k) a[k] = __builtin_sqrtf(a[k]);
  return a;
}
MPM_INLINE PackD larger(PackD a, PackD b) { return a > b ? a : b; }
MPM_INLINE PackF larger(PackF a, PackF b) { return a > b ? a : b; }
MPM_INLINE PackD smaller(PackD a, PackD b) { return a < b ? a : b; }
MPM_INLINE PackF smaller(PackF a, PackF b) { return a < b ? a : b; }
MPM_INLINE int bits(Mask<double> m) {
  int set = 0;
  for (int l = 0; l < 4; ++l) set |= m[l] ? 1 << l : 0;
  return set;
}
MPM_INLINE int bits(Mask<float> m) {
  int set = 0;
  for (int l = 0; l < 8; ++l) set |= m[l] ? 1 << l : 0;
  return set;
}
#endif
MPM_INLINE bool any(Mask<double> m) { return bits(m) != 0; }
MPM_INLINE bool any(Mask<float> m) { return bits(m) != 0; }
MPM_INLINE PackD magnitude(PackD a) { return (PackD)((Mask<double>)a & INT64_MAX); }
MPM_INLINE PackF magnitude(PackF a) { return (PackF)((Mask<float>)a & INT32_MAX); }
/// a where the mask says so, else 0.
template <class Real>
MPM_INLINE Pack<Real> where(Mask<Real> mask, Pack<Real> a) {
  return (Pack<Real>)((Mask<Real>)a & mask);
}
/// use.operator()<a>() for a = first ... last - 1, as so many statements: arrays that are indexed by a are
/// then as good as variables.
template <int last, int first = 0, class Use>
MPM_INLINE void each(Use use) {
  if constexpr (first < last) {
    use.template operator()<first>();
    each<last, first + 1>(use);
  }
}

/// a.a
template <int axes, class P>
MPM_INLINE P square_of(const P* a) {
  P sum = a[0] * a[0];
  each<axes, 1>([&]<int k>() __attribute__((always_inline)) { sum = sum + a[k] * a[k]; });
  return sum;
}
/// The nearest whole numbers. |a| < 2^22.
template <class Real>
MPM_INLINE Pack<Real> rounded(Pack<Real> a) {
  return (a + Lanes<Real>::round_to_whole) - Lanes<Real>::round_to_whole;
}

MPM_INLINE Whole<float> larger(Whole<float> a, Whole<float> b) { return a > b ? a : b; }
MPM_INLINE Whole<float> smaller(Whole<float> a, Whole<float> b) { return a < b ? a : b; }
/// Whole numbers as reals, and the nearest to a real, or one beside it.
MPM_INLINE PackD real_of(Whole<double> a) { return a; }
MPM_INLINE PackF real_of(Whole<float> a) { return __builtin_convertvector(a, PackF); }
MPM_INLINE Whole<double> whole_of(PackD a) { return rounded<double>(a); }
MPM_INLINE Whole<float> whole_of(PackF a) { return __builtin_convertvector(a, Whole<float>); }

/// Lane l is from[at[l]].
MPM_INLINE PackD fetched(const double* from, const std::int32_t* at) {
  return PackD{from[at[0]], from[at[1]], from[at[2]], from[at[3]]};
}
MPM_INLINE PackF fetched(const float* from, const std::int32_t* at) {
  return PackF{from[at[0]], from[at[1]], from[at[2]], from[at[3]],
               from[at[4]], from[at[5]], from[at[6]], from[at[7]]};
}

/// Of the numbers n of two neighbouring packs, those at l, l + 1 and l + 2 in lane l.
MPM_INLINE void columns_of(PackD a, PackD b, PackD* column) {
  column[0] = a;
  column[2] = __builtin_shufflevector(a, b, 2, 3, 4, 5);
  column[1] = __builtin_shufflevector(a, column[2], 1, 4, 3, 6);
}
MPM_INLINE void columns_of(PackF a, PackF b, PackF* column) {
  const PackF middle = __builtin_shufflevector(a, b, 4, 5, 6, 7, 8, 9, 10, 11);
  column[0] = a;
  column[1] = __builtin_shufflevector(a, b, 1, 2, 3, 4, 5, 6, 7, 8);
  column[2] = __builtin_shufflevector(a, middle, 2, 3, 8, 9, 6, 7, 12, 13);
}
/// Those at l - k in lane l of the second pack.
template <int k>
MPM_INLINE PackD shifted(PackD before, PackD a) {
  return __builtin_shufflevector(before, a, 4 - k, 5 - k, 6 - k, 7 - k);
}
template <int k>
MPM_INLINE PackF shifted(PackF before, PackF a) {
  return __builtin_shufflevector(before, a, 8 - k, 9 - k, 10 - k, 11 - k, 12 - k, 13 - k, 14 - k, 15 - k);
}

}  // namespace mpm::fast::MPM_ISA

namespace mpm {

/// Packs as numbers of material models. Everything is inlined, so that the instruction sets stay apart.
template <>
struct Number<fast::MPM_ISA::PackD> {
  using Scalar = double;
  using N = fast::MPM_ISA::PackD;
  static constexpr int width = 4;
  static MPM_INLINE double lane(const N& a, int k) { return a[k]; }
  static MPM_INLINE void set_lane(N& a, int k, double v) { a[k] = v; }
  static MPM_INLINE N square_root(N a) { return fast::MPM_ISA::square_root(a); }
  static MPM_INLINE N logarithm_of_one_plus(N a) {
    for (int k = 0; k < 4; ++k) a[k] = __builtin_log1p(a[k]);
    return a;
  }
  static MPM_INLINE N larger(N a, N b) { return fast::MPM_ISA::larger(a, b); }
  static MPM_INLINE N smaller(N a, N b) { return fast::MPM_ISA::smaller(a, b); }
  static MPM_INLINE N all(double a) { return fast::MPM_ISA::all(a); }
};
template <>
struct Number<fast::MPM_ISA::PackF> {
  using Scalar = float;
  using N = fast::MPM_ISA::PackF;
  static constexpr int width = 8;
  static MPM_INLINE float lane(const N& a, int k) { return a[k]; }
  static MPM_INLINE void set_lane(N& a, int k, float v) { a[k] = v; }
  static MPM_INLINE N square_root(N a) { return fast::MPM_ISA::square_root(a); }
  static MPM_INLINE N logarithm_of_one_plus(N a) {
    for (int k = 0; k < 8; ++k) a[k] = __builtin_log1pf(a[k]);
    return a;
  }
  static MPM_INLINE N larger(N a, N b) { return fast::MPM_ISA::larger(a, b); }
  static MPM_INLINE N smaller(N a, N b) { return fast::MPM_ISA::smaller(a, b); }
  static MPM_INLINE N all(float a) { return fast::MPM_ISA::all(a); }
};

}  // namespace mpm
