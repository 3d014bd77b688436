#pragma once
/// The list of what is compiled, for the instruction set of the translation unit that includes this.
#include "libmpm/step/fast/move_nodes.hpp"
#include "libmpm/step/fast/sweep.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real, bool gimp, bool back_stress, bool linear_tension>
Kernels<Real> compiled() {
  using S = Sweep<Real, gimp, back_stress, linear_tension>;
  return {S::scatter, S::sweep, move_nodes<Real>};
}

template <class Real>
Kernels<Real> choose(const Variant& v) {
  if (v.gimp) {
    if (v.back_stress)
      return v.linear_tension ? compiled<Real, true, true, true>() : compiled<Real, true, true, false>();
    return v.linear_tension ? compiled<Real, true, false, true>() : compiled<Real, true, false, false>();
  }
  if (v.back_stress)
    return v.linear_tension ? compiled<Real, false, true, true>() : compiled<Real, false, true, false>();
  return v.linear_tension ? compiled<Real, false, false, true>() : compiled<Real, false, false, false>();
}

}  // namespace mpm::fast::MPM_ISA
