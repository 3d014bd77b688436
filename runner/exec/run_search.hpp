#pragma once
/// A study with [search], against a catalog: rounds of jobs until every critical value is bracketed.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runner/exec/run_studies.hpp"
#include "runner/search/forecast.hpp"
#include "runner/search/search.hpp"

namespace mpmstudy {

struct SearchOptions {
  CostModel cost;  ///< for predictions
  bool retry_failed = false;
  double audit = 0;    ///< share of the runs that ended early which are run to their end, 0 ... 1
  StudySource source;  ///< of the study; for those who ask the catalog later
};

/// What an audit of early stops found.
struct Audit {
  std::int64_t early = 0;                ///< runs that were to stop when decided
  std::int64_t audited = 0;              ///< of them, run to the end
  std::vector<std::string> disagreeing;  ///< keys of those whose whole run says something else
};

struct SearchReport {
  RunReport run;  ///< of all rounds; what was done before or has failed: of the study as it is now
  std::vector<FoundBracket> brackets;
  Audit audit;

  /// Points without a bracket, of a search that has ended.
  std::int64_t not_found() const;
  /// The state of the study, whatever was done now: 0 every bracket found and no job failed, 1 some not, 75
  /// stopped with work left, 130 interrupted.
  int exit_code() const;
};

/// Runs, or has others run, every job of a study that is not decided. A report with work left ends the search
/// for now.
using RunRound = std::function<RunReport(const PlannedStudy&)>;

/// Every job of the search becomes one of the study's; brackets go to the view `brackets` once the search
/// has ended. After a signal no round begins. Jobs that are done are not run again: a search that was stopped
/// goes on, and ends with the same brackets. The runs of an audit belong to the study NAME-audit. Throws
/// CatalogError.
SearchReport run_search(const Study&, const SearchOptions&, CatalogWriter&,
                        const std::filesystem::path& results, const RunRound&);
/// On the threads of this process.
SearchReport run_search(const Study&, const SearchOptions&, CatalogWriter&, Status&, const Simulate&,
                        const WriteSnapshot&, StopFlag&, const ExecutorOptions&);

/// What the search will still run, by what the catalog knows of its runs. Without a catalog nothing is known.
/// Failed runs are run again with `retry_failed`.
SearchForecast forecast_search(const Study&, const std::filesystem::path& results, bool retry_failed);

/// Of all scenes that the search, or its audit, may ask for, whatever the runs say: those whose keys are
/// wanted. There may be too many for a list of all.
std::vector<mpm::Scene> possible_scenes(const Study&,
                                        const std::function<bool(const std::string& key)>& wanted);

}  // namespace mpmstudy
