// Compiled for whatever the build says; on plain x86-64 that is SSE2.
#define MPM_ISA baseline
#include "libmpm/step/fast/instantiate.hpp"

namespace mpm::fast::baseline {
Kernels<double> kernels(const Variant& v) { return choose<double>(v); }
}  // namespace mpm::fast::baseline
