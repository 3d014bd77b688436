#include "runner/bench/roofline.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "libmpm/core/thread_clock.hpp"
#include "libmpm/step/fast/kernels.hpp"

#if defined(__x86_64__)
#define MPMSTUDY_AVX2 __attribute__((target("avx2,fma")))
#else
#define MPMSTUDY_AVX2
#endif

namespace mpmstudy {
namespace {

/// Ten independent chains are enough to hide the latency of a multiply-add. Returns operations.
template <class Vector>
double multiply_add_plain(long rounds) {
  constexpr int lanes = sizeof(Vector) / sizeof(Vector{}[0]);
  Vector a0{}, a1{}, a2{}, a3{}, a4{}, a5{}, a6{}, a7{}, a8{}, a9{};
  Vector x{}, y{};
  for (int l = 0; l < lanes; ++l) x[l] = 0.5F, y[l] = 1;
  for (long i = 0; i < rounds; ++i) {
    a0 = a0 * x + y, a1 = a1 * x + y, a2 = a2 * x + y, a3 = a3 * x + y, a4 = a4 * x + y;
    a5 = a5 * x + y, a6 = a6 * x + y, a7 = a7 * x + y, a8 = a8 * x + y, a9 = a9 * x + y;
    asm volatile("" : "+x"(a0), "+x"(a1), "+x"(a2), "+x"(a3), "+x"(a4));
    asm volatile("" : "+x"(a5), "+x"(a6), "+x"(a7), "+x"(a8), "+x"(a9));
  }
  return 2.0 * 10 * lanes * static_cast<double>(rounds);
}

/// The same with fused multiply-add, where the processor has it.
template <class Vector>
MPMSTUDY_AVX2 __attribute__((optimize("fp-contract=fast"))) double multiply_add_fused(long rounds) {
  constexpr int lanes = sizeof(Vector) / sizeof(Vector{}[0]);
  Vector a0{}, a1{}, a2{}, a3{}, a4{}, a5{}, a6{}, a7{}, a8{}, a9{};
  Vector x{}, y{};
  for (int l = 0; l < lanes; ++l) x[l] = 0.5F, y[l] = 1;
  for (long i = 0; i < rounds; ++i) {
    a0 = a0 * x + y, a1 = a1 * x + y, a2 = a2 * x + y, a3 = a3 * x + y, a4 = a4 * x + y;
    a5 = a5 * x + y, a6 = a6 * x + y, a7 = a7 * x + y, a8 = a8 * x + y, a9 = a9 * x + y;
    asm volatile("" : "+x"(a0), "+x"(a1), "+x"(a2), "+x"(a3), "+x"(a4));
    asm volatile("" : "+x"(a5), "+x"(a6), "+x"(a7), "+x"(a8), "+x"(a9));
  }
  return 2.0 * 10 * lanes * static_cast<double>(rounds);
}

typedef double Double2 __attribute__((vector_size(16)));
typedef double Double4 __attribute__((vector_size(32)));
typedef float Float4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));

/// Work per second, the best of a few.
template <class Work>
double best_rate(int repetitions, double seconds, Work work) {
  double best = 0;
  for (int k = 0; k < repetitions; ++k) {
    const double start = mpm::thread_cpu_seconds();
    double done = 0;
    do done += work();
    while (mpm::thread_cpu_seconds() - start < seconds);
    best = std::max(best, done / (mpm::thread_cpu_seconds() - start));
  }
  return best;
}

}  // namespace

Roofline measure_roofline(int repetitions, double seconds) {
  const bool fused = mpm::fast::supported(mpm::fast::InstructionSet::avx2);
  constexpr long rounds = 100000;
  constexpr std::size_t count = std::size_t{1} << 23;  // 64 MiB per array
  Roofline r;
  r.gigaflops_double =
      1e-9 * best_rate(repetitions, seconds, [&] {
        return fused ? multiply_add_fused<Double4>(rounds) : multiply_add_plain<Double2>(rounds);
      });
  r.gigaflops_float =
      1e-9 * best_rate(repetitions, seconds, [&] {
        return fused ? multiply_add_fused<Float8>(rounds) : multiply_add_plain<Float4>(rounds);
      });
  std::vector<double> a(count, 0), b(count, 1), c(count, 2);
  r.gigabytes_per_second = 1e-9 * best_rate(repetitions, seconds, [&] {
                             for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 0.5 * c[i];
                             asm volatile("" : : "r"(a.data()) : "memory");
                             return 3.0 * sizeof(double) * static_cast<double>(count);
                           });
  return r;
}

double roofline_rate(const Roofline& r, const KernelWork& w, bool single_precision) {
  const double flops = 1e9 * (single_precision ? r.gigaflops_float : r.gigaflops_double);
  return 1 / std::max(w.operations / flops, w.bytes / (1e9 * r.gigabytes_per_second));
}

}  // namespace mpmstudy
