#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace mpm {

/// Threads that do the parts of one piece of work together and wait for the next. The caller is one of them.
/// Not for use by several threads at once.
class ThreadTeam {
 public:
  ThreadTeam() = default;
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// From the next piece of work on, with the caller. At least 1.
  void resize(int threads);
  int size() const { return static_cast<int>(helpers_.size()) + 1; }

  /// Calls part(0) ... part(parts - 1), each once, in any order and on any thread of the team, and returns
  /// when all have returned. They must not throw.
  void run(std::size_t parts, const std::function<void(std::size_t)>& part);

  /// Processor time of the threads beside the caller, so far [s].
  double helper_seconds() const { return seconds_.load(); }

 private:
  void help();
  void do_parts();
  void offer();

  std::vector<std::thread> helpers_;
  const std::function<void(std::size_t)>* part_ = nullptr;  // of the present work
  std::size_t parts_ = 0;                                   // of the present work
  std::atomic<std::size_t> next_{0};
  /// The present work: its number, how many helpers have joined it, whether more may. A helper that comes
  /// late, because the processor had something else to do, is not waited for.
  std::atomic<std::uint32_t> work_{0};
  std::atomic<std::uint32_t> returned_{0};  ///< of those that have joined
  std::atomic<bool> end_{false};
  std::atomic<double> seconds_{0};
};

}  // namespace mpm
