// Compiled for AVX2 (see libmpm/CMakeLists.txt); called only where the processor has it.
#define MPM_ISA avx2
#include "libmpm/step/fast/instantiate.hpp"

namespace mpm::fast::avx2 {
Kernels<double> kernels(const Variant& v) { return choose<double>(v); }
}  // namespace mpm::fast::avx2
