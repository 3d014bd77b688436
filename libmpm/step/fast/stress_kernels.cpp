// The stress updates, for the instruction set, the number and the number of axes that the build says (see
// CMakeLists.txt).
#include "libmpm/material/list.hpp"
#include "libmpm/step/fast/update_stress.hpp"

namespace mpm::fast::MPM_ISA {
namespace {

template <class Space, class... Models>
StressUpdate<MPM_REAL, MPM_AXES> of_list(std::size_t model, ModelList<Models...>) {
  constexpr StressUpdate<MPM_REAL, MPM_AXES> updates[] = {
      {UpdateStress<MPM_REAL, Models, Space>::update, UpdateStress<MPM_REAL, Models, Space>::report}...};
  return updates[model];
}

}  // namespace

template <class Real, int axes>
StressUpdate<Real, axes> stress_update(std::size_t model, Space);

template <>
StressUpdate<MPM_REAL, MPM_AXES> stress_update(std::size_t model, Space space) {
  return space::with_space<MPM_AXES>(
      space, [&]<class S>(S) { return of_list<S>(model, CompiledModels<MPM_REAL>{}); });
}

}  // namespace mpm::fast::MPM_ISA
