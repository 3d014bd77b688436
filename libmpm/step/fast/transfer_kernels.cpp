// The transfers, for the instruction set and the number that the build says (see CMakeLists.txt).
#include "libmpm/step/fast/move_nodes.hpp"
#include "libmpm/step/fast/sweep.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real>
Transfers<Real> transfers(bool gimp);

template <>
Transfers<MPM_REAL> transfers(bool gimp) {
  using Real = MPM_REAL;
  if (gimp)
    return {Sweep<Real, true>::scatter, Sweep<Real, true>::sweep, collect_nodes<Real>, move_nodes<Real>};
  return {Sweep<Real, false>::scatter, Sweep<Real, false>::sweep, collect_nodes<Real>, move_nodes<Real>};
}

}  // namespace mpm::fast::MPM_ISA
