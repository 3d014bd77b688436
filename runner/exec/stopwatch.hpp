#pragma once
#include <chrono>
#include <thread>

#include "runner/exec/signals.hpp"

namespace mpmstudy {

/// Time of a job, without the time for which the whole process was stopped (SIGSTOP, Ctrl-Z, a scheduler that
/// suspends it). Read it often: the time between two readings is left out if the process was resumed between
/// them. One thread.
class Stopwatch {
 public:
  double seconds() {
    const auto now = Clock::now();
    if (now - last_ > std::chrono::milliseconds(200)) wait_for_a_resumption((now - last_) / 100);
    if (const int n = resumptions(); n != resumptions_) {
      resumptions_ = n;
      start_ += now - last_;
    }
    last_ = now;
    return std::chrono::duration<double>(now - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// After a stop this thread may go on before the one that takes the signal which says so.
  void wait_for_a_resumption(Clock::duration at_most) const {
    const auto until = Clock::now() + at_most;
    while (resumptions() == resumptions_ && Clock::now() < until)
      std::this_thread::sleep_for(std::chrono::microseconds(500));
  }

  Clock::time_point start_ = Clock::now(), last_ = start_;
  int resumptions_ = resumptions();
};

}  // namespace mpmstudy
