#include "runner/exec/executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "runner/exec/isolation.hpp"
#include "runner/exec/job_queue.hpp"
#include "runner/exec/processors.hpp"

namespace mpmstudy {
namespace {

using Clock = std::chrono::steady_clock;

/// At most 30 years, which the clock can add.
std::chrono::milliseconds milliseconds(double seconds) {
  constexpr double most = 1e9;
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000 * std::min(seconds, most)));
}

unsigned threads_of(const ExecutorOptions& options) {
  return options.workers ? options.workers : static_cast<unsigned>(usable_processors());
}

class Executor {
 public:
  Executor(std::vector<Job> jobs, const Simulate& simulate, const WriteSnapshot& write, Ledger& ledger,
           Status& status, StopFlag& flag, const ExecutorOptions& options)
      : queue_(std::move(jobs)),
        server_(simulate, write, options.results),
        simulate_(simulate),
        write_(write),
        ledger_(ledger),
        status_(status),
        flag_(flag),
        options_(options) {}

  ExecutorReport run() {
    active_ = worker_count(options_, queue_.jobs().size());
    std::vector<std::thread> threads;
    for (unsigned i = 0, count = active_; i < count; ++i) threads.emplace_back([this] { work(); });
    wait_for_workers();
    for (auto& thread : threads) thread.join();
    report_.untouched += static_cast<std::int64_t>(queue_.left());
    report_.budget_spent = report_.untouched > 0 && budget_spent() && !flag_.wanted();
    if (error_) std::rethrow_exception(error_);
    ledger_.flush();
    return report_;
  }

 private:
  bool stopping() const { return stop_.load(std::memory_order_relaxed) || flag_.wanted(); }
  bool budget_spent() const {
    return options_.budget_s > 0 && Clock::now() - start_ > milliseconds(options_.budget_s);
  }

  void wait_for_workers() {
    std::unique_lock lock(mutex_);
    std::optional<Clock::time_point> asked;
    while (active_ > 0) {
      ended_.wait_for(lock, std::chrono::milliseconds(50));
      if (!flag_.wanted()) continue;
      if (!asked) asked = Clock::now();
      if (options_.abandon && active_ > 0 && Clock::now() - *asked > milliseconds(options_.grace_s)) {
        auto report = report_;
        const auto running = running_;
        lock.unlock();
        abandon(std::move(report), running);
        lock.lock();
        asked = Clock::now();
      }
    }
  }

  /// The jobs go back before the process ends, or the next start would take them for crashed.
  void abandon(ExecutorReport report, const std::set<std::string>& running) {
    for (const auto& key : running) ledger_.release(key, "stopped");
    ledger_.flush();
    report.stopped += static_cast<std::int64_t>(running.size());
    report.untouched += static_cast<std::int64_t>(queue_.left());
    options_.abandon(report);
  }

  void work() noexcept {
    try {
      while (const Job* job = queue_.next([this] { return stopping() || budget_spent(); })) ask_for(*job);
    } catch (...) {
      std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      stop_ = true;
    }
    std::lock_guard lock(mutex_);
    --active_;
    ended_.notify_one();
  }

  void ask_for(const Job& job) {
    const JobReservation reservation = ledger_.reserve(job.key);
    if (reservation) return run_job(job, reservation.crashes > 0 || options_.limits.memory > 0);
    if (reservation.status == JobStatus::running)
      return queue_.put_off(&job, milliseconds(options_.look_again_s));
    std::lock_guard lock(mutex_);
    ++(reservation.status == JobStatus::done     ? report_.done_elsewhere
       : reservation.status == JobStatus::failed ? report_.failed_elsewhere
                                                 : report_.untouched);
  }

  /// Threads without a job help those that are left. Under mutex_.
  void share_threads() {
    const auto running = static_cast<unsigned>(running_.size());
    const bool all_taken = queue_.left() <= queue_.waiting();
    share_ = all_taken && running > 0 ? std::max(1, static_cast<int>(threads_of(options_) / running)) : 1;
  }

  /// Attempts until the job is decided or released.
  void run_job(const Job& job, bool isolated) {
    {
      std::lock_guard lock(mutex_);
      running_.insert(job.key);
      share_threads();
    }
    status_.job_started(job);
    for (std::int64_t retry = 0;;) {
      Attempt attempt = make_attempt(job, isolated);
      using enum Attempt::End;
      if (attempt.end != decided && !ledger_.holds(job.key)) return taken_over(job);
      if (attempt.end == stopped) return let_go(job, "");
      if (attempt.end == storage) return stop_for_storage(job, attempt.why);
      if (attempt.end == crashed) {
        if (stopping()) return let_go(job, "");
        const auto crashes = ledger_.crashed(job.key);
        attempt.job.reason = fmt::format("{}; crashes so far: {}, from {} on the job is failed", attempt.why,
                                         crashes, options_.most_crashes);
        if (crashes < options_.most_crashes) {
          if (!again(job, attempt.job.reason)) return;
          continue;
        }
      }
      if (attempt.job.failure && retry < options_.retries) {
        ++retry;
        if (!again(job, fmt::format("retry {} of {}: {}", retry, options_.retries, attempt.job.reason)))
          return;
        continue;
      }
      return decide(job, std::move(attempt.job));
    }
  }

  Attempt make_attempt(const Job& job, bool isolated) {
    const AttemptContext context{simulate_,
                                 write_,
                                 options_.results,
                                 options_.limits,
                                 [this, &job] { return stopping() || ledger_.lost(job.key); },
                                 [&](const mpm::Progress& p) { status_.job_progress(job, p); },
                                 [this] { return share_.load(std::memory_order_relaxed); },
                                 options_.checkpoint_s,
                                 [this, &job] { return ledger_.lost(job.key); },
                                 [&](const std::string& text) { status_.job_noted(job, text); }};
    if (!isolated) return attempt_job(job, context);
    return server_.attempt(job, context);
  }

  /// running -> planned -> running: a new attempt. False if another process was quicker.
  bool again(const Job& job, const std::string& why) {
    ledger_.release(job.key, why);
    JobEnd end;
    end.status = JobStatus::planned;
    end.reason = why;
    status_.job_finished(job, end);
    if (ledger_.reserve(job.key)) {
      status_.job_started(job);
      return true;
    }
    std::lock_guard lock(mutex_);
    running_.erase(job.key);
    share_threads();
    queue_.put_off(&job, milliseconds(options_.look_again_s));
    return false;
  }

  /// Another process has it now, since it held this one for gone: its result counts, and is waited for.
  void taken_over(const Job& job) {
    JobEnd end;
    end.status = JobStatus::planned;
    end.reason = "another process has taken it up";
    status_.job_finished(job, end);
    std::lock_guard lock(mutex_);
    running_.erase(job.key);
    share_threads();
    queue_.put_off(&job, milliseconds(options_.look_again_s));
  }

  /// why: "" if the run was asked to stop.
  void let_go(const Job& job, const std::string& why) {
    ledger_.release(job.key, why.empty() ? "stopped" : why);
    JobEnd end;
    end.status = JobStatus::planned;
    end.reason = why;
    status_.job_finished(job, end);
    std::lock_guard lock(mutex_);
    running_.erase(job.key);
    share_threads();
    ++report_.stopped;
  }

  void stop_for_storage(const Job& job, const std::string& why) {
    let_go(job, why);
    std::lock_guard lock(mutex_);
    if (report_.storage_error.empty()) report_.storage_error = why;
    stop_ = true;
  }

  void decide(const Job& job, FinishedJob finished) {
    const bool failed = finished.status == JobStatus::failed;
    JobEnd end{finished.status,       finished.reason, finished.result.particles,
               finished.result.steps, finished.wall_s, finished.cpu_s};
    if (!ledger_.complete(std::move(finished))) return taken_over(job);
    status_.job_finished(job, end);
    std::lock_guard lock(mutex_);
    running_.erase(job.key);
    share_threads();
    ++(failed ? report_.failed : report_.done);
    report_.updates += end.updates();
    report_.cpu_s += end.cpu_s;
    if (!failed) report_.predicted_s += job.predicted_seconds;
  }

  JobQueue queue_;
  JobServer server_;  // before any thread
  const Simulate& simulate_;
  const WriteSnapshot& write_;
  Ledger& ledger_;
  Status& status_;
  const StopFlag& flag_;
  const ExecutorOptions& options_;
  const Clock::time_point start_ = Clock::now();

  std::atomic<bool> stop_{false};
  std::atomic<int> share_{1};  ///< threads of each job that runs
  std::mutex mutex_;
  std::condition_variable ended_;
  unsigned active_ = 0;            // guarded by mutex_; workers
  std::set<std::string> running_;  // guarded by mutex_; keys
  ExecutorReport report_;          // guarded by mutex_
  std::exception_ptr error_;       // guarded by mutex_
};

}  // namespace

unsigned worker_count(const ExecutorOptions& options, std::size_t jobs) {
  return static_cast<unsigned>(
      std::clamp<std::size_t>(threads_of(options), 1, std::max<std::size_t>(jobs, 1)));
}

ExecutorReport execute_jobs(std::vector<Job> jobs, const Simulate& simulate, const WriteSnapshot& write,
                            Ledger& ledger, Status& status, StopFlag& flag, const ExecutorOptions& options) {
  if (jobs.empty()) {
    ledger.flush();
    return {};
  }
  return Executor(std::move(jobs), simulate, write, ledger, status, flag, options).run();
}

}  // namespace mpmstudy
