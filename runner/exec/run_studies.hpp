#pragma once
/// The engine: one run of some studies against a catalog. Their planners say what is wanted, workers run what
/// is not decided, and both go on in turns until no planner wants any more.
#include <functional>
#include <map>
#include <span>
#include <string>

#include "runner/catalog/writer.hpp"
#include "runner/exec/study_run.hpp"
#include "runner/exec/workers.hpp"
#include "runner/status/status.hpp"

namespace mpmstudy {

/// What an audit of early stops found.
struct Audit {
  std::int64_t early = 0;                ///< runs that were to stop when decided
  std::int64_t audited = 0;              ///< of them, run to the end
  std::vector<std::string> disagreeing;  ///< keys of those whose whole run says something else
};

/// Of a search that has ended.
struct SearchReport {
  std::vector<FoundBracket> brackets;
  Audit audit;
  /// Points without a bracket.
  std::int64_t not_found() const;
};

struct RunReport {
  ExecutorReport executed;
  std::int64_t reused = 0;                       ///< done before
  std::int64_t left_failed = 0;                  ///< failed before and left so
  int signal = 0;                                ///< that stopped the run, or 0
  std::map<std::string, SearchReport> searches;  ///< by name of the study

  std::int64_t left() const { return executed.left(); }
  /// The state of the studies, whatever was done now: 0 all decided and every bracket found, 1 some jobs
  /// failed or some brackets are not found, 75 stopped with work left, 130 interrupted.
  int exit_code() const;
};

struct EngineOptions {
  std::filesystem::path results = "results";
  bool retry_failed = false;
  /// Told which jobs the study at this place of the list wants, before they run; an audit's are its search's.
  std::function<void(std::size_t study, const std::vector<Job>&)> on_wanted = {};
};

/// Studies share their jobs: a key is run once. What all of them want now is one queue. Jobs that another
/// process runs are waited for. Brackets go to the view `brackets` once their search has ended. After a
/// signal no round begins. Jobs that are done are not run again: a search that was stopped goes on, and ends
/// with the same brackets. Throws CatalogError.
RunReport run_studies(std::span<const PlannedStudy>, CatalogWriter&, Workers&, Status&, StopFlag&,
                      const EngineOptions&);
/// On the threads of this process.
RunReport run_studies(std::span<const PlannedStudy>, bool retry_failed, CatalogWriter&, Status&,
                      const Simulate&, const WriteSnapshot&, StopFlag&, const ExecutorOptions&);

}  // namespace mpmstudy
