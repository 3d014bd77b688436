#pragma once
/// The numbers that material models are written over: `double`, or a pack of numbers side by side (the packs
/// of the fast step: step/fast/lanes.hpp). Besides + - * / and comparisons a model uses what stands here;
/// where it decides, it writes `condition ? a : b`, which for packs is decided lane by lane.
#include <cmath>

/// For all functions over numbers. The same text is compiled for several instruction sets: a copy of a
/// function that is not inlined might be the one that the linker keeps for all of them.
#define MPM_INLINE inline __attribute__((always_inline))

namespace mpm {

/// Specialised for every number. `Scalar`: the type of one lane, and of a model's constants.
template <class N>
struct Number;

template <>
struct Number<double> {
  using Scalar = double;
  static constexpr int width = 1;  ///< lanes
  static MPM_INLINE double lane(double a, int) { return a; }
  static MPM_INLINE void set_lane(double& a, int, double v) { a = v; }
  static MPM_INLINE double square_root(double a) { return std::sqrt(a); }
  /// ln(1 + a)
  static MPM_INLINE double logarithm_of_one_plus(double a) { return std::log1p(a); }
  /// The larger one; b where either is not a number.
  static MPM_INLINE double larger(double a, double b) { return a > b ? a : b; }
  /// The smaller one; b where either is not a number.
  static MPM_INLINE double smaller(double a, double b) { return a < b ? a : b; }
  static MPM_INLINE double all(double a) { return a; }
};

template <class N>
using Scalar = typename Number<N>::Scalar;

}  // namespace mpm
