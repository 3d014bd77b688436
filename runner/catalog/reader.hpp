#pragma once
/// What `status` and `plan` ask of a catalog. Each call opens it read-only and answers from one moment.
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/plan/cost_model.hpp"

namespace mpmstudy {

struct StudyState {
  std::string name, title;
  std::map<JobStatus, std::int64_t> jobs;  ///< only states that occur
};

struct RunningJob {
  std::string key;
  std::string study;  ///< "": none
  std::string by;     ///< "host:pid"
  std::string since;  ///< UTC
  std::int64_t attempt = 0;
  /// Why nobody runs it any longer; a run of its study takes it up. "": it is being run, or `last_sign` is
  /// all that can be known here.
  std::string gone;
  /// Of a process that cannot be looked for from here (another host or namespace): its last sign of life, UTC
  /// by its own clock. Else "".
  std::string last_sign;
};

struct FailedJob {
  std::string key;
  std::string study;  ///< "": none
  std::string reason;
};

struct CatalogState {
  std::vector<StudyState> studies;
  StudyState no_study;  ///< jobs that no study has any longer; its name is ""; empty where studies are named
  std::int64_t stale = 0;      ///< jobs of an older physics version, in whatever study
  std::int64_t processes = 0;  ///< that work on this catalog now; between two jobs, too
  std::vector<RunningJob> running;
  std::vector<FailedJob> failed;
};

/// The studies named, or all. Throws CatalogError: no catalog, or a name that it does not have.
CatalogState read_state(const std::filesystem::path& results, const std::vector<std::string>& studies = {});

/// What the newest jobs done on this host have cost, at most a thousand; none where there is no catalog.
std::vector<CostSample> measured_costs(const std::filesystem::path& results);

}  // namespace mpmstudy
