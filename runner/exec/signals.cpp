#include "runner/exec/signals.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace mpmstudy {
namespace {

static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may use lock-free atomics only");
StopFlag flag;  // the one global: see the header
std::atomic<std::int64_t> asked_at{0};
std::atomic<int> resumed{0};
std::atomic<bool> closed{false};

constexpr std::array stopping = {SIGINT,  SIGTERM, SIGHUP,  SIGQUIT,   SIGUSR1, SIGUSR2,
                                 SIGXCPU, SIGPWR,  SIGALRM, SIGVTALRM, SIGPROF};
constexpr std::array others = {SIGPIPE, SIGXFSZ, SIGCONT};
std::array<struct sigaction, stopping.size() + others.size()> old_actions;

constexpr std::int64_t one_request = 500'000'000;  // [ns]

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

extern "C" void on_stop(int number) {
  if (!flag.wanted()) {
    asked_at.store(now());
    flag.ask(number);
    return;
  }
  if (number == SIGXCPU || now() - asked_at.load() < one_request) return;
  _exit(128 + number);
}

extern "C" void on_pipe(int) {
  const int error = errno;
  for (const int file : {STDOUT_FILENO, STDERR_FILENO}) {
    pollfd end{file, POLLOUT, 0};
    if (poll(&end, 1, 0) != 1 || (end.revents & (POLLERR | POLLHUP)) == 0) continue;
    if (file == STDOUT_FILENO) closed = true;
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, file);
    close(nowhere);
  }
  errno = error;
}

extern "C" void on_resumption(int) { resumed.fetch_add(1); }

void (*handler_of(int number))(int) {
  switch (number) {
    case SIGPIPE:
      return on_pipe;
    case SIGXFSZ:
      return SIG_IGN;
    case SIGCONT:
      return on_resumption;
    default:
      return on_stop;
  }
}

template <class Visit>
void for_each_signal(Visit visit) {
  std::size_t i = 0;
  for (const int number : stopping) visit(number, old_actions[i++]);
  for (const int number : others) visit(number, old_actions[i++]);
}

}  // namespace

StopFlag& signal_flag() { return flag; }

SignalGuard::SignalGuard() {
  flag.clear();
  closed = false;
  for_each_signal([](int number, struct sigaction& old) {
    struct sigaction action {};
    action.sa_handler = handler_of(number);
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(number, &action, &old);
    if ((number == SIGHUP || number == SIGQUIT) && old.sa_handler == SIG_IGN)
      sigaction(number, &old, nullptr);
  });
}

SignalGuard::~SignalGuard() {
  for_each_signal([](int number, struct sigaction& old) { sigaction(number, &old, nullptr); });
}

bool output_closed() { return closed; }

int resumptions() { return resumed; }

std::string signal_name(int number) {
  const char* name = sigabbrev_np(number);
  return name != nullptr ? std::string("SIG") + name : "signal " + std::to_string(number);
}

void ignore_stop_signals() {
  for (const int number : stopping) signal(number, SIG_IGN);
}

}  // namespace mpmstudy
