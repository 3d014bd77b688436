#pragma once
/// Signs of life of runners that this process cannot look at: of other hosts, kernels and namespaces. Clocks
/// of machines differ and step, so no time of another clock is compared with one of this clock: a runner is
/// silent from the moment at which its sign of life was last seen to change, by this process's own monotonic
/// clock.
#include <chrono>
#include <cstdint>
#include <map>
#include <string>

namespace mpmstudy {

class Heartbeats {
 public:
  using Clock = std::chrono::steady_clock;

  /// `sign` is what the catalog has of the runner now; any other text than the last one is a sign of life.
  /// Gives back for how long it has been silent [s]: 0 when it is seen for the first time.
  ///
  /// A process that was stopped, or a share that hung, sees everybody silent at once. So one look adds at
  /// most `most_s` of silence: others have had that time, and more looks, to say something.
  double silence(std::int64_t runner, const std::string& sign, double most_s, Clock::time_point now);

 private:
  struct Seen {
    std::string sign;
    Clock::time_point at;
    double silent_s = 0;
  };
  std::map<std::int64_t, Seen> runners_;
};

}  // namespace mpmstudy
