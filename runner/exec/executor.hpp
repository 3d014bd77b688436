#pragma once
/// Runs jobs on worker threads: longest predicted job first, one simulation a thread. What it runs, where
/// results go, who watches and when to stop are all given to it. The results do not depend on the workers.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/simulation.hpp"
#include "runner/exec/job_files.hpp"
#include "runner/exec/ledger.hpp"
#include "runner/exec/signals.hpp"
#include "runner/plan/plan.hpp"
#include "runner/status/status.hpp"

namespace mpmstudy {

/// mpm::run, or what a test puts in its place. Called from several threads at once.
using Simulate = std::function<mpm::RunResult(const mpm::Scene&, mpm::Observer&)>;

struct ExecutorOptions {
  std::filesystem::path results = "results";
  unsigned workers = 0;  ///< 0: one a hardware thread
};

/// How many threads that many jobs get: at least one, no more than there are jobs.
unsigned worker_count(const ExecutorOptions&, std::size_t jobs);

struct ExecutorReport {
  std::int64_t done = 0;
  std::int64_t failed = 0;
  std::int64_t stopped = 0;    ///< were running and are planned again
  std::int64_t untouched = 0;  ///< not started
  std::int64_t elsewhere = 0;  ///< another process was faster
  double updates = 0;          ///< particles x steps over all decided jobs
  double cpu_s = 0;            ///< [s]
  std::string storage_error;   ///< why the run stopped itself, or ""

  bool work_left() const { return stopped + untouched + elsewhere > 0; }
};

/// Returns when every job is decided, or after a stop when every worker has let go of its job. A job that
/// throws is failed with its reason and the rest goes on. Throws what the ledger throws, after all workers
/// have ended.
ExecutorReport execute_jobs(std::vector<Job>, const Simulate&, const WriteSnapshot&, Ledger&, Status&,
                            StopFlag&, const ExecutorOptions&);

}  // namespace mpmstudy
