// The transfers, for the instruction set, the number and the number of axes that the build says (see
// CMakeLists.txt).
#include "libmpm/step/fast/move_nodes.hpp"
#include "libmpm/step/fast/sweep.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real, int axes>
Transfers<Real, axes> transfers(bool gimp, Space);

template <>
Transfers<MPM_REAL, MPM_AXES> transfers(bool gimp, Space space) {
  using Real = MPM_REAL;
  const auto of = []<class S>(S) -> Transfers<Real, MPM_AXES> {
    return {S::scatter, S::sweep, collect_nodes<Real, MPM_AXES>, move_nodes<Real, MPM_AXES>};
  };
  return space::with_space<MPM_AXES>(
      space, [&]<class S>(S) { return gimp ? of(Sweep<Real, true, S>{}) : of(Sweep<Real, false, S>{}); });
}

}  // namespace mpm::fast::MPM_ISA
