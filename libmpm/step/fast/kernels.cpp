#include "libmpm/step/fast/kernels.hpp"

#include <stdexcept>

namespace mpm::fast {
namespace baseline {
template <class Real, int axes>
Transfers<Real, axes> transfers(bool gimp, Space);
template <class Real, int axes>
StressUpdate<Real, axes> stress_update(std::size_t model, Space);
}  // namespace baseline
namespace avx2 {
template <class Real, int axes>
Transfers<Real, axes> transfers(bool gimp, Space);
template <class Real, int axes>
StressUpdate<Real, axes> stress_update(std::size_t model, Space);
}  // namespace avx2

bool supported(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
    case InstructionSet::avx2:
#if defined(MPM_KERNELS_AVX2)
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
      return false;
#endif
  }
  return false;
}

InstructionSet best_instruction_set() {
  return supported(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::baseline;
}

template <class Real, int axes>
Kernels<Real, axes> kernels_for(bool gimp, Space space, std::size_t model, InstructionSet set) {
  if (!supported(set)) throw std::logic_error("this processor lacks the instruction set");
#if defined(MPM_KERNELS_AVX2)
  if (set == InstructionSet::avx2)
    return {avx2::transfers<Real, axes>(gimp, space), avx2::stress_update<Real, axes>(model, space)};
#endif
  return {baseline::transfers<Real, axes>(gimp, space), baseline::stress_update<Real, axes>(model, space)};
}

template Kernels<double, 2> kernels_for(bool, Space, std::size_t, InstructionSet);
template Kernels<float, 2> kernels_for(bool, Space, std::size_t, InstructionSet);
template Kernels<double, 3> kernels_for(bool, Space, std::size_t, InstructionSet);
template Kernels<float, 3> kernels_for(bool, Space, std::size_t, InstructionSet);

}  // namespace mpm::fast
