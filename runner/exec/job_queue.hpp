#pragma once
/// The jobs of a run that are not decided, longest first; behind them those that another process runs, to be
/// asked for again. Any thread.
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <vector>

#include "runner/plan/plan.hpp"

namespace mpmstudy {

class JobQueue {
 public:
  using Clock = std::chrono::steady_clock;

  explicit JobQueue(std::vector<Job>);

  const std::vector<Job>& jobs() const { return jobs_; }

  /// The next job to ask for: one that nobody was seen running, or one that was put off long enough ago.
  /// Waits where there are only others. Null: none is left, or `stopping`.
  const Job* next(const std::function<bool()>& stopping);
  /// Another process runs it: ask again after this time.
  void put_off(const Job*, Clock::duration);
  /// Jobs that next() has not given, or that were put off.
  std::size_t left() const;
  /// Jobs that others were last seen running.
  std::size_t waiting() const;

 private:
  struct Later {
    const Job* job;
    Clock::time_point when;
  };
  const std::vector<Job> jobs_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;     // guarded by mutex_
  std::deque<Later> later_;  // guarded by mutex_; in order of time
};

}  // namespace mpmstudy
