#pragma once
/// One attempt at one job, on the thread that calls: simulate, write its files, say how it went.
#include <functional>
#include <optional>
#include <string>

#include "libmpm/simulation.hpp"
#include "runner/catalog/records.hpp"
#include "runner/exec/job_files.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {

/// mpm::run, or what a test puts in its place. Called from several threads at once.
using Simulate = std::function<mpm::RunResult(const mpm::Scene&, mpm::Observer&)>;

/// What a job may use. 0: no bound.
struct Limits {
  double seconds = 0;        ///< wall time of one attempt [s]
  std::uint64_t memory = 0;  ///< of one attempt, which then runs in a process of its own [bytes]
};

struct AttemptContext {
  const Simulate& simulate;
  const WriteSnapshot& write;
  std::filesystem::path results;
  Limits limits;
  std::function<bool()> stopping;                      ///< asked after every step
  std::function<void(const mpm::Progress&)> progress;  ///< at most twenty times per second
  std::function<int()> threads = [] { return 1; };  ///< that the next step may use; asked before every step
  double checkpoint_s = 0;                          ///< processor time between checkpoints [s]; 0: none
  /// Another process has taken the job up: its files are that one's now, so nothing of them is touched.
  std::function<bool()> lost = [] { return false; };
  /// What a user has to know about this attempt: that it begins anew, and why.
  std::function<void(const std::string&)> note = [](const std::string&) {};
};

/// How an attempt ended.
struct Attempt {
  enum class End {
    decided,  ///< `job` is what it left: done or failed
    stopped,  ///< it was asked to
    storage,  ///< a file cannot be written: not the job's fault; `why` says
    crashed   ///< its process died; `why` says how
  };
  End end = End::decided;
  FinishedJob job;
  std::string why;
};

/// Does not throw what a simulation throws: that is a failed job.
Attempt attempt_job(const Job&, const AttemptContext&);

}  // namespace mpmstudy
