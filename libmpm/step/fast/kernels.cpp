#include "libmpm/step/fast/kernels.hpp"

namespace mpm::fast {

bool supported(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
    case InstructionSet::avx2:
#if defined(MPM_KERNELS_AVX2)
      return __builtin_cpu_supports("avx2");
#else
      return false;
#endif
  }
  return false;
}

Kernels<double> kernels_for(const Variant& v, InstructionSet set) {
  if (!supported(set)) return {};
#if defined(MPM_KERNELS_AVX2)
  if (set == InstructionSet::avx2) return avx2::kernels(v);
#endif
  return baseline::kernels(v);
}

Kernels<double> kernels_for(const Variant& v) {
  return kernels_for(v, supported(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::baseline);
}

}  // namespace mpm::fast
