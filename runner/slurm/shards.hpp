#pragma once
/// How the jobs of a study are dealt out to the elements of a job array. Pure.
#include <vector>

#include "runner/plan/plan.hpp"

namespace mpmstudy {

struct Shard {
  std::vector<const Job*> jobs;  ///< longest first
  double seconds = 0;            ///< predicted sum, on one core [s]
};

/// As few shards as keep each near `seconds` of predicted time on `workers` threads, at most `most`; the
/// longest job first to the shard that has least. No shard is empty.
std::vector<Shard> make_shards(const std::vector<const Job*>& jobs, double seconds, int workers,
                               std::size_t most);

}  // namespace mpmstudy
