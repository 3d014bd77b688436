#include "runner/exec/job_queue.hpp"

#include <algorithm>

namespace mpmstudy {
namespace {

std::vector<Job> longest_first(std::vector<Job> jobs) {
  std::ranges::stable_sort(jobs, std::ranges::greater{}, &Job::predicted_seconds);
  return jobs;
}

/// A signal handler cannot wake a thread that waits: it checks this often.
constexpr std::chrono::milliseconds look_up{100};

}  // namespace

JobQueue::JobQueue(std::vector<Job> jobs) : jobs_(longest_first(std::move(jobs))) {}

const Job* JobQueue::next(const std::function<bool()>& stopping) {
  std::unique_lock lock(mutex_);
  while (!stopping()) {
    if (next_ < jobs_.size()) return &jobs_[next_++];
    if (later_.empty()) return nullptr;
    const auto now = Clock::now();
    if (later_.front().when <= now) {
      const Job* job = later_.front().job;
      later_.pop_front();
      return job;
    }
    changed_.wait_until(lock, std::min(later_.front().when, now + look_up));
  }
  return nullptr;
}

void JobQueue::put_off(const Job* job, Clock::duration time) {
  {
    std::lock_guard lock(mutex_);
    later_.push_back({job, Clock::now() + time});
  }
  changed_.notify_one();
}

std::size_t JobQueue::left() const {
  std::lock_guard lock(mutex_);
  return jobs_.size() - next_ + later_.size();
}

std::size_t JobQueue::waiting() const {
  std::lock_guard lock(mutex_);
  return later_.size();
}

}  // namespace mpmstudy
