#pragma once
/// Runs jobs on worker threads: longest predicted job first, one simulation per thread; at the end, threads
/// without a job help the simulations that still run. What it runs, where results go, who watches and when to
/// stop are all given to it. The results do not depend on the workers.
///
/// Several executors, in several processes, may work on one ledger: each takes what nobody runs, and at the
/// end waits for what the others still run, so that a job whose process dies is taken up.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runner/exec/attempt.hpp"
#include "runner/exec/ledger.hpp"
#include "runner/exec/signals.hpp"
#include "runner/plan/plan.hpp"
#include "runner/status/status.hpp"

namespace mpmstudy {

struct ExecutorReport {
  std::int64_t done = 0;
  std::int64_t failed = 0;
  std::int64_t stopped = 0;                               ///< were running and are planned again
  std::int64_t untouched = 0;                             ///< not started
  std::int64_t done_elsewhere = 0, failed_elsewhere = 0;  ///< decided by another process meanwhile
  double updates = 0;                                     ///< particles x steps over all decided jobs
  double cpu_s = 0;                                       ///< [s]
  double predicted_s = 0;     ///< what was predicted for the jobs that are done [s]
  bool budget_spent = false;  ///< jobs were not started for that
  std::string storage_error;  ///< why the run stopped itself, or ""

  std::int64_t left() const { return stopped + untouched; }
};

struct ExecutorOptions {
  std::filesystem::path results = "results";
  unsigned workers = 0;  ///< 0: one per hardware thread
  Limits limits = {};
  std::int64_t retries = 0;       ///< how often a failed job is run again in this run
  std::int64_t most_crashes = 3;  ///< a job whose process has died that often is failed
  double checkpoint_s = 60;       ///< processor time between the checkpoints of a job [s]; 0: none
  double budget_s = 0;            ///< wall time after which no more jobs are started [s]; 0: none
  double grace_s = 1.5;       ///< after a stop is asked for, workers have this long to release their jobs [s]
  double look_again_s = 0.5;  ///< jobs of other processes are asked for this often [s]
  /// A worker did not release its job in time: its job is planned again and this is called, to end the
  /// process. If it returns, the worker is waited for.
  std::function<void(const ExecutorReport&)> abandon = {};
};

/// How many threads that many jobs get: at least one, no more than there are jobs.
unsigned worker_count(const ExecutorOptions&, std::size_t jobs);

/// Returns when every job is decided, or after a stop when every worker has released its job. A job that
/// throws is failed with its reason and the rest goes on. A job whose process has died before runs in a
/// process of its own. Throws what the ledger throws, after all workers have ended. Forks (see
/// isolation.hpp): the caller has no other threads that run jobs.
ExecutorReport execute_jobs(std::vector<Job>, const Simulate&, const WriteSnapshot&, Ledger&, Status&,
                            StopFlag&, const ExecutorOptions&);

}  // namespace mpmstudy
