// The stress updates, for the instruction set and the number that the build says (see libmpm/CMakeLists.txt).
#include "libmpm/step/fast/constitutive.hpp"

namespace mpm::fast::MPM_ISA {
namespace {

template <bool linear_tension>
StressUpdate<MPM_REAL> with_strength(const Variant& v) {
  const auto compiled = []<Variant variant>() -> StressUpdate<MPM_REAL> {
    return {Constitutive<MPM_REAL, variant>::update, Constitutive<MPM_REAL, variant>::report};
  };
  if (v.back_stress) return compiled.template operator()<Variant{false, true, true, linear_tension}>();
  return v.plastic ? compiled.template operator()<Variant{false, true, false, linear_tension}>()
                   : compiled.template operator()<Variant{false, false, false, linear_tension}>();
}

}  // namespace

template <class Real>
StressUpdate<Real> stress_update(const Variant&);

template <>
StressUpdate<MPM_REAL> stress_update(const Variant& v) {
  return v.linear_tension ? with_strength<true>(v) : with_strength<false>(v);
}

}  // namespace mpm::fast::MPM_ISA
