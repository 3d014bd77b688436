#include "libmpm/step/fast/kernels.hpp"

#include <stdexcept>

namespace mpm::fast {
namespace baseline {
template <class Real>
Transfers<Real> transfers(bool gimp);
template <class Real>
StressUpdate<Real> stress_update(const Variant&);
}  // namespace baseline
namespace avx2 {
template <class Real>
Transfers<Real> transfers(bool gimp);
template <class Real>
StressUpdate<Real> stress_update(const Variant&);
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
Kernels<Real> kernels_for(const Variant& v, InstructionSet set) {
  if (!supported(set)) throw std::logic_error("this processor lacks the instruction set");
#if defined(MPM_KERNELS_AVX2)
  if (set == InstructionSet::avx2) return {avx2::transfers<Real>(v.gimp), avx2::stress_update<Real>(v)};
#endif
  return {baseline::transfers<Real>(v.gimp), baseline::stress_update<Real>(v)};
}

template Kernels<double> kernels_for(const Variant&, InstructionSet);
template Kernels<float> kernels_for(const Variant&, InstructionSet);

}  // namespace mpm::fast
