#pragma once
/// What runs will need: memory and time. Pure.
#include <vector>

#include "runner/plan/plan.hpp"

namespace mpmstudy {

/// Memory of one job while it runs [bytes]: particles and grid of its kernel, with the copy that samples and
/// snapshots are taken from. With the memory of the program itself, which comes to it once, within a tenth of
/// the peak that was measured for `run -j 1` with 19404 and 215552 particles, in double, in float and with
/// the plain step.
double predicted_bytes(const mpm::Scene&, const mpm::Estimate&);

struct Demand {
  double bytes = 0;         ///< of the largest jobs that may run at one time, program included
  double wall_seconds = 0;  ///< the longest job first
  double largest = 0;       ///< of the largest of them [bytes]
};
Demand demand_of(const std::vector<Job>&, int workers);

}  // namespace mpmstudy
