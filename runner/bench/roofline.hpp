#pragma once
/// What this core can do at best, measured: how fast it multiplies and adds, and how fast memory streams.

namespace mpmstudy {

struct Roofline {
  double gigaflops_double = 0;      ///< fused multiply-adds on registers, two operations each [1e9/s]
  double gigaflops_float = 0;       ///< the same
  double gigabytes_per_second = 0;  ///< a = b + s c over arrays that no cache holds, three streams [1e9 B/s]
};

/// Each number is the best of `repetitions`, of `seconds` of processor time each.
Roofline measure_roofline(int repetitions, double seconds);

/// Work and traffic of the fast step, for the two numbers above.
struct KernelWork {
  double operations = 0;  ///< floating-point operations per particle update
  double bytes = 0;       ///< that a particle update moves between core and memory
};
/// Particle updates per second that the roofline allows.
double roofline_rate(const Roofline&, const KernelWork&, bool single_precision);

}  // namespace mpmstudy
