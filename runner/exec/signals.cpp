#include "runner/exec/signals.hpp"

#include <signal.h>
#include <unistd.h>

namespace mpmstudy {
namespace {

static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may use lock-free atomics only");
StopFlag flag;  // the one global: see the header
struct sigaction old_int, old_term;

extern "C" void on_signal(int number) {
  if (flag.wanted()) _exit(128 + number);
  flag.ask(number);
}

}  // namespace

StopFlag& signal_flag() { return flag; }

SignalGuard::SignalGuard() {
  flag.clear();
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &old_int);
  sigaction(SIGTERM, &action, &old_term);
}

SignalGuard::~SignalGuard() {
  sigaction(SIGINT, &old_int, nullptr);
  sigaction(SIGTERM, &old_term, nullptr);
}

}  // namespace mpmstudy
