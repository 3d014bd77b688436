// The transfers, for the instruction set and the number that the build says (see CMakeLists.txt).
#include "libmpm/step/fast/move_nodes.hpp"
#include "libmpm/step/fast/sweep.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real>
Transfers<Real> transfers(bool gimp, Space);

template <>
Transfers<MPM_REAL> transfers(bool gimp, Space space) {
  using Real = MPM_REAL;
  const auto of = []<class S>(S) -> Transfers<Real> {
    return {S::scatter, S::sweep, collect_nodes<Real>, move_nodes<Real>};
  };
  return space::with_space(
      space, [&]<class S>(S) { return gimp ? of(Sweep<Real, true, S>{}) : of(Sweep<Real, false, S>{}); });
}

}  // namespace mpm::fast::MPM_ISA
