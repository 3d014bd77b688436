#pragma once
/// What `status` and `plan` ask of a catalog. Each call opens it read-only and answers from one moment.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"

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
};

struct FailedJob {
  std::string key;
  std::string study;  ///< "": none
  std::string reason;
};

struct CatalogState {
  std::vector<StudyState> studies;
  StudyState no_study;  ///< jobs that no study has any longer; its name is ""; empty where studies are named
  std::int64_t stale = 0;  ///< jobs of an older physics version, in whatever study
  std::vector<RunningJob> running;
  std::vector<FailedJob> failed;
};

/// The studies named, or all. Throws CatalogError: no catalog, or a name that it does not have.
CatalogState read_state(const std::filesystem::path& results, const std::vector<std::string>& studies = {});

/// Particle updates a second and core of the jobs done on this host; empty where there are none, or no
/// catalog.
std::optional<double> measured_updates_per_second(const std::filesystem::path& results);

}  // namespace mpmstudy
