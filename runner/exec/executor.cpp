#include "runner/exec/executor.hpp"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

namespace mpmstudy {
namespace {

using Clock = std::chrono::steady_clock;

/// Time that this thread has spent on a processor [s].
double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Watches one job for the executor: stops it when asked, hands snapshots to disk, tells the status.
class JobObserver : public mpm::Observer {
 public:
  JobObserver(const Job& job, JobFiles& files, Status& status, const std::atomic<bool>& stop,
              const StopFlag& flag)
      : job_(job), files_(files), status_(status), stop_(stop), flag_(flag) {}

  bool on_step(const mpm::Progress& progress) override {
    if (const auto now = Clock::now(); now - last_ >= std::chrono::milliseconds(50)) {
      last_ = now;
      status_.job_progress(job_, progress);
    }
    return !stop_.load(std::memory_order_relaxed) && !flag_.wanted();
  }
  void on_snapshot(const mpm::Snapshot& snapshot) override { files_.add(snapshot); }

 private:
  const Job& job_;
  JobFiles& files_;
  Status& status_;
  const std::atomic<bool>& stop_;
  const StopFlag& flag_;
  Clock::time_point last_{};
};

class Executor {
 public:
  Executor(std::vector<Job> jobs, const Simulate& simulate, const WriteSnapshot& write, Ledger& ledger,
           Status& status, StopFlag& flag, const ExecutorOptions& options)
      : jobs_(std::move(jobs)),
        simulate_(simulate),
        write_(write),
        ledger_(ledger),
        status_(status),
        flag_(flag),
        options_(options) {
    std::ranges::stable_sort(jobs_, std::ranges::greater{}, &Job::predicted_seconds);
  }

  ExecutorReport run() {
    const unsigned count = worker_count(options_, jobs_.size());
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < count; ++i) threads.emplace_back([this] { work(); });
    for (auto& thread : threads) thread.join();
    report_.untouched += static_cast<std::int64_t>(jobs_.size() - std::min(next_.load(), jobs_.size()));
    if (error_) std::rethrow_exception(error_);
    ledger_.flush();
    return report_;
  }

 private:
  bool stopping() const { return stop_.load(std::memory_order_relaxed) || flag_.wanted(); }

  void work() noexcept {
    try {
      while (!stopping()) {
        const std::size_t i = next_.fetch_add(1);
        if (i >= jobs_.size()) return;
        run_job(jobs_[i]);
      }
    } catch (...) {
      std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      stop_ = true;
    }
  }

  void run_job(const Job& job) {
    if (!ledger_.claim(job.key)) {
      std::lock_guard lock(mutex_);
      ++report_.elsewhere;
      return;
    }
    status_.job_started(job);
    const auto wall = Clock::now();
    const double cpu = thread_cpu_seconds();
    FinishedJob finished;
    finished.key = job.key;
    try {
      JobFiles files(options_.results, job.key, write_);
      finished.result = simulate(job, files);
      if (finished.result.status == mpm::RunStatus::stopped) {
        files.discard();
        let_go(job, "");
        return;
      }
      finished.snapshots = files.close();
    } catch (const StorageError& error) {
      let_go(job, error.what());
      std::lock_guard lock(mutex_);
      if (report_.storage_error.empty()) report_.storage_error = error.what();
      stop_ = true;
      return;
    }
    finished.wall_s = seconds_since(wall);
    finished.cpu_s = thread_cpu_seconds() - cpu;
    decide(job, std::move(finished));
  }

  /// A breakdown is a value; whatever a simulation throws is made one.
  mpm::RunResult simulate(const Job& job, JobFiles& files) {
    JobObserver observer(job, files, status_, stop_, flag_);
    try {
      return simulate_(job.scene, observer);
    } catch (const StorageError&) {
      throw;
    } catch (const std::bad_alloc&) {
      return failure("out of memory");
    } catch (const std::exception& error) {
      return failure(error.what());
    } catch (...) {
      return failure("an exception that is not a std::exception");
    }
  }

  static mpm::RunResult failure(std::string reason) {
    mpm::RunResult result;
    result.status = mpm::RunStatus::failed;
    result.reason = std::move(reason);
    return result;
  }

  /// why: "" if the run was asked to stop.
  void let_go(const Job& job, const std::string& why) {
    ledger_.release(job.key, why.empty() ? "stopped" : why);
    JobEnd end;
    end.status = JobStatus::planned;
    end.reason = why;
    status_.job_finished(job, end);
    std::lock_guard lock(mutex_);
    ++report_.stopped;
  }

  void decide(const Job& job, FinishedJob finished) {
    const bool failed = finished.result.status == mpm::RunStatus::failed;
    finished.status = failed ? JobStatus::failed : JobStatus::done;
    finished.reason = finished.result.reason;
    if (failed && finished.reason.empty()) finished.reason = "failed without a reason";
    JobEnd end{finished.status,       finished.reason, finished.result.particles,
               finished.result.steps, finished.wall_s, finished.cpu_s};
    ledger_.finish(std::move(finished));
    status_.job_finished(job, end);
    std::lock_guard lock(mutex_);
    ++(failed ? report_.failed : report_.done);
    report_.updates += end.updates();
    report_.cpu_s += end.cpu_s;
  }

  std::vector<Job> jobs_;
  const Simulate& simulate_;
  const WriteSnapshot& write_;
  Ledger& ledger_;
  Status& status_;
  const StopFlag& flag_;
  const ExecutorOptions& options_;

  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  ExecutorReport report_;     // guarded by mutex_
  std::exception_ptr error_;  // guarded by mutex_
};

}  // namespace

unsigned worker_count(const ExecutorOptions& options, std::size_t jobs) {
  const std::size_t wanted = options.workers ? options.workers : std::thread::hardware_concurrency();
  return static_cast<unsigned>(std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(jobs, 1)));
}

ExecutorReport execute_jobs(std::vector<Job> jobs, const Simulate& simulate, const WriteSnapshot& write,
                            Ledger& ledger, Status& status, StopFlag& flag, const ExecutorOptions& options) {
  return Executor(std::move(jobs), simulate, write, ledger, status, flag, options).run();
}

}  // namespace mpmstudy
