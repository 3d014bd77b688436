#pragma once
/// A deviator as particles keep it, and the numbers that models and steps keep of it.
#include "libmpm/core/full_symmetric.hpp"
#include "libmpm/core/tensor.hpp"

namespace mpm {

inline Deviator<double> numbers_of(const PlaneTensor& t) { return {t.xx, t.yy, t.xy}; }
inline FullDeviator<double> numbers_of(const FullTensor& t) { return {t.xx, t.yy, t.xy, t.xz, t.yz}; }
inline PlaneTensor tensor_of(const Deviator<double>& s) { return {s.xx, s.yy, -(s.xx + s.yy), s.xy}; }
inline FullTensor tensor_of(const FullDeviator<double>& s) {
  return {s.xx, s.yy, -(s.xx + s.yy), s.xy, s.xz, s.yz};
}

}  // namespace mpm
