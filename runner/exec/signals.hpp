#pragma once
/// The wish to stop. One flag a process, because a signal handler can reach nothing else; everything that
/// reads it is given a StopFlag.
#include <atomic>

namespace mpmstudy {

/// Why a run is to stop. Any thread.
class StopFlag {
 public:
  /// The number of the signal that asked, or 0.
  int signal() const { return signal_.load(std::memory_order_relaxed); }
  bool wanted() const { return signal() != 0; }
  void ask(int signal) { signal_.store(signal, std::memory_order_relaxed); }
  void clear() { ask(0); }

 private:
  std::atomic<int> signal_{0};
};

/// The flag that SIGINT and SIGTERM raise while a SignalGuard lives.
StopFlag& signal_flag();

/// While it lives: the first SIGINT or SIGTERM raises signal_flag(); a second one ends the process at once,
/// with 128 + its number (jobs then still named running are taken up by the next start). Clears the flag
/// first and restores the old handlers last. One at a time, on the main thread.
class SignalGuard {
 public:
  SignalGuard();
  ~SignalGuard();
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;
};

}  // namespace mpmstudy
