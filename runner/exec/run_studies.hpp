#pragma once
/// One run of some studies against a catalog: register, execute what is not decided, count.
#include <span>
#include <string>

#include "runner/catalog/writer.hpp"
#include "runner/exec/executor.hpp"
#include "runner/plan/plan.hpp"
#include "runner/status/status.hpp"

namespace mpmstudy {

struct PlannedStudy {
  Plan plan;
  std::string title;
  StudySource source = {};
  /// Of a run that is to run some jobs only; all others stay what they are. Keys may be those of finer cells,
  /// or of jobs that a search may ask for, as well.
  Selection selection = {};
};

/// The jobs that a run of the study begins with: those of the plan that the selection has, each key once.
std::vector<Job> jobs_to_run(const PlannedStudy&);

struct RunReport {
  ExecutorReport executed;
  std::int64_t reused = 0;       ///< done before
  std::int64_t left_failed = 0;  ///< failed before and left so
  int signal = 0;                ///< that stopped the run, or 0

  /// What was done before counts as often as it was found.
  RunReport& operator+=(const RunReport& next);
  std::int64_t left() const { return executed.left(); }
  /// 0 all decided, 1 some jobs failed, 75 stopped with work left, 130 interrupted.
  int exit_code() const;
};

/// Studies share their jobs: a key is run once. Their jobs are one queue. Jobs that another process runs are
/// waited for. Throws CatalogError.
RunReport run_studies(std::span<const PlannedStudy>, bool retry_failed, CatalogWriter&, Status&,
                      const Simulate&, const WriteSnapshot&, StopFlag&, const ExecutorOptions&);

}  // namespace mpmstudy
