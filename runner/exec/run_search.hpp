#pragma once
/// A study with [search], against a catalog: rounds of jobs until every critical value is bracketed.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runner/exec/run_studies.hpp"
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
  RunReport run;  ///< of all rounds
  std::vector<FoundBracket> brackets;
  Audit audit;
};

/// Runs, or has others run, every job of a study that is not decided. A report with work left ends the search
/// for now.
using RunRound = std::function<RunReport(const PlannedStudy&)>;

/// Every job of the search becomes one of the study's; brackets go to the view critical_speed once the search
/// has ended. Jobs that are done are not run again: a search that was stopped goes on, and ends with the same
/// brackets. The runs of an audit belong to the study NAME-audit. Throws CatalogError.
SearchReport run_search(const Study&, const SearchOptions&, CatalogWriter&,
                        const std::filesystem::path& results, const RunRound&);
/// On the threads of this process.
SearchReport run_search(const Study&, const SearchOptions&, CatalogWriter&, Status&, const Simulate&,
                        const WriteSnapshot&, StopFlag&, const ExecutorOptions&);

/// Every scene that the search, or its audit, may ask for, whatever the runs say.
std::vector<mpm::Scene> possible_scenes(const Study&);

}  // namespace mpmstudy
