#include "runner/catalog/heartbeats.hpp"

#include <algorithm>

namespace mpmstudy {

double Heartbeats::silence(std::int64_t runner, const std::string& sign, double most_s,
                           Clock::time_point now) {
  const auto [it, is_new] = runners_.try_emplace(runner, Seen{sign, now, 0});
  Seen& seen = it->second;
  if (is_new) return 0;
  const double since = std::chrono::duration<double>(now - seen.at).count();
  seen.at = now;
  if (seen.sign != sign) {
    seen.sign = sign;
    seen.silent_s = 0;
  } else {
    seen.silent_s += std::min(since, most_s);
  }
  return seen.silent_s;
}

}  // namespace mpmstudy
