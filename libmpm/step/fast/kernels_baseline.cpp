// Compiled for whatever the build says; on plain x86-64 that is SSE2.
#define MPM_ISA baseline
#include "libmpm/step/fast/instantiate.hpp"

namespace mpm::fast::baseline {
template Kernels<double> kernels(const Variant&);
template Kernels<float> kernels(const Variant&);
}  // namespace mpm::fast::baseline
