#pragma once
/// The request to stop, and the other signals that must not end a run. One flag per process, because a signal
/// handler can reach nothing else; everything that reads it is given a StopFlag.
#include <atomic>
#include <string>

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

/// The flag that is raised by the signals that ask for an end, while a SignalGuard lives.
StopFlag& signal_flag();

/// While it lives:
///
/// - INT, TERM, HUP, QUIT, USR1, USR2, XCPU, PWR: the first one raises signal_flag(). Another one ends the
///   process at once with 128 + its number; jobs then still named running are taken up by the next start. No
///   second request: what comes within half a second (`timeout`, batch systems and init send one request to
///   process and group, or two signals in a row), and XCPU, which the kernel repeats every second.
/// - HUP and QUIT stay ignored where they were (nohup; background of a shell).
/// - PIPE: standard output or error whose reader has gone is replaced by /dev/null; see output_closed().
/// - XFSZ is ignored: the write then fails with "File too large", as on a disk that is full.
/// - CONT is counted; see resumptions().
///
/// Clears the flag first and restores the old handlers last. One at a time, on the main thread.
class SignalGuard {
 public:
  SignalGuard();
  ~SignalGuard();
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;
};

/// Has the reader of standard output gone (`mpmstudy run -v | head -3`)? What is printed is lost since.
bool output_closed();

/// How often the process has gone on after it was stopped (SIGSTOP, Ctrl-Z).
int resumptions();

/// "SIGHUP"
std::string signal_name(int number);

/// For a process that must not end when its parent is told to: ignores the signals that ask for an end.
void ignore_stop_signals();

}  // namespace mpmstudy
