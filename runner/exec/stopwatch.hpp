#pragma once
#include <chrono>

#include "runner/exec/signals.hpp"

namespace mpmstudy {

/// Time of a job, without the time for which the whole process was stopped (SIGSTOP, Ctrl-Z, a scheduler that
/// suspends it): that is not the job's. Asked often, since what lies between two questions is left out where
/// a resumption lies between them. One thread.
class Stopwatch {
 public:
  double seconds() {
    const auto now = Clock::now();
    if (const int n = resumptions(); n != resumptions_) {
      resumptions_ = n;
      start_ += now - last_;
    }
    last_ = now;
    return std::chrono::duration<double>(now - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  int resumptions_ = resumptions();
};

}  // namespace mpmstudy
