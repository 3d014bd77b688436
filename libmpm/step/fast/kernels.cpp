#include "libmpm/step/fast/kernels.hpp"

#include <stdexcept>

namespace mpm::fast {
namespace baseline {
template <class Real>
Transfers<Real> transfers(bool gimp, Space);
template <class Real>
StressUpdate<Real> stress_update(std::size_t model, Space);
}  // namespace baseline
namespace avx2 {
template <class Real>
Transfers<Real> transfers(bool gimp, Space);
template <class Real>
StressUpdate<Real> stress_update(std::size_t model, Space);
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

template <class Real>
Kernels<Real> kernels_for(bool gimp, Space space, std::size_t model, InstructionSet set) {
  if (!supported(set)) throw std::logic_error("this processor lacks the instruction set");
#if defined(MPM_KERNELS_AVX2)
  if (set == InstructionSet::avx2)
    return {avx2::transfers<Real>(gimp, space), avx2::stress_update<Real>(model, space)};
#endif
  return {baseline::transfers<Real>(gimp, space), baseline::stress_update<Real>(model, space)};
}

template Kernels<double> kernels_for(bool, Space, std::size_t, InstructionSet);
template Kernels<float> kernels_for(bool, Space, std::size_t, InstructionSet);

}  // namespace mpm::fast
