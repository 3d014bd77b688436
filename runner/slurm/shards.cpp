#include "runner/slurm/shards.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace mpmstudy {

std::vector<Shard> make_shards(const std::vector<const Job*>& jobs, double seconds, int workers,
                               std::size_t most) {
  if (jobs.empty()) return {};
  auto longest_first = jobs;
  std::ranges::stable_sort(longest_first, std::ranges::greater{}, &Job::predicted_seconds);
  double sum = 0;
  for (const Job* job : jobs) sum += job->predicted_seconds;
  const double wanted = std::ceil(sum / (seconds * workers));
  const auto count =
      static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(std::min(most, jobs.size()))));
  std::vector<Shard> shards(count);
  using Load = std::pair<double, std::size_t>;  // equal loads: the first shard
  std::priority_queue<Load, std::vector<Load>, std::greater<>> least;
  for (std::size_t i = 0; i < count; ++i) least.emplace(0, i);
  for (const Job* job : longest_first) {
    const auto [load, i] = least.top();
    least.pop();
    shards[i].jobs.push_back(job);
    shards[i].seconds = load + job->predicted_seconds;
    // A job that is predicted to take no time still takes a place.
    least.emplace(std::nextafter(shards[i].seconds, 2 * shards[i].seconds + 1), i);
  }
  std::erase_if(shards, [](const Shard& shard) { return shard.jobs.empty(); });
  return shards;
}

}  // namespace mpmstudy
