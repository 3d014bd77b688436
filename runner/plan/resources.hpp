#pragma once
/// What runs will take of a machine: memory, and hours. Pure.
#include <vector>

#include "runner/plan/plan.hpp"

namespace mpmstudy {

/// Memory of one job while it runs [bytes]: particles and grid of its kernel, with the copy that samples and
/// snapshots are taken from. Within a fifth of what was measured from 40000 to 1.6 million particles
/// (studies/README.md); memory of the program itself comes to it once.
double predicted_bytes(const mpm::Scene&, const mpm::Estimate&);

struct Demand {
  double bytes = 0;         ///< of the largest jobs that may run at one time, program included
  double wall_seconds = 0;  ///< the longest job first
};
Demand demand_of(const std::vector<Job>&, int workers);

}  // namespace mpmstudy
