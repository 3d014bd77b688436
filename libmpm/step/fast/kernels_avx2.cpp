// Compiled for AVX2 and FMA (see libmpm/CMakeLists.txt); called only where the processor has them.
#define MPM_ISA avx2
#include "libmpm/step/fast/instantiate.hpp"

namespace mpm::fast::avx2 {
template Kernels<double> kernels(const Variant&);
template Kernels<float> kernels(const Variant&);
}  // namespace mpm::fast::avx2
