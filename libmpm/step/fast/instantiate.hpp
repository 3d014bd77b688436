#pragma once
/// The list of what is compiled, for the instruction set of the translation unit that includes this.
#include "libmpm/step/fast/move_nodes.hpp"
#include "libmpm/step/fast/sweep.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real, Variant variant>
Kernels<Real> compiled() {
  using S = Sweep<Real, variant>;
  return {S::scatter, S::sweep, collect_nodes<Real>, move_nodes<Real>};
}

template <class Real, bool gimp, bool linear_tension>
Kernels<Real> with_strength(const Variant& v) {
  if (v.back_stress) return compiled<Real, Variant{gimp, true, true, linear_tension}>();
  return v.plastic ? compiled<Real, Variant{gimp, true, false, linear_tension}>()
                   : compiled<Real, Variant{gimp, false, false, linear_tension}>();
}

template <class Real>
Kernels<Real> kernels(const Variant& v) {
  if (v.gimp)
    return v.linear_tension ? with_strength<Real, true, true>(v) : with_strength<Real, true, false>(v);
  return v.linear_tension ? with_strength<Real, false, true>(v) : with_strength<Real, false, false>(v);
}

}  // namespace mpm::fast::MPM_ISA
