// The stress updates, for the instruction set and the number that the build says (see CMakeLists.txt).
#include "libmpm/material/list.hpp"
#include "libmpm/step/fast/update_stress.hpp"

namespace mpm::fast::MPM_ISA {
namespace {

template <class... Models>
StressUpdate<MPM_REAL> of_list(std::size_t model, ModelList<Models...>) {
  constexpr StressUpdate<MPM_REAL> updates[] = {
      {UpdateStress<MPM_REAL, Models>::update, UpdateStress<MPM_REAL, Models>::report}...};
  return updates[model];
}

}  // namespace

template <class Real>
StressUpdate<Real> stress_update(std::size_t model);

template <>
StressUpdate<MPM_REAL> stress_update(std::size_t model) {
  return of_list(model, CompiledModels<MPM_REAL>{});
}

}  // namespace mpm::fast::MPM_ISA
