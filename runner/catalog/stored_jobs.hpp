#pragma once
/// Jobs as the catalog has them, with the scene that they were made from.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {

struct StoredJob {
  Job job;
  JobStatus status = JobStatus::planned;
  std::string reason;        ///< of a failure
  std::string failure_kind;  ///< of a failed job
  std::int64_t attempt = 0;
  std::int64_t crashes = 0;
  std::int64_t steps = 0;  ///< of a decided job
  int physics_version = 0;
  std::int64_t order = 0;  ///< in which jobs came into the catalog
};

/// Which jobs; "": all.
struct JobFilter {
  std::string key_begins;
  std::string status;
};

/// In the order in which they came into the catalog. Throws CatalogError.
std::vector<StoredJob> read_jobs(const std::filesystem::path& results, const JobFilter& = {});

/// A study of the catalog and where its file was when it was last run.
struct StoredStudy {
  std::string name;
  StudySource source;  ///< path "": not known
};
std::vector<StoredStudy> read_studies(const std::filesystem::path& results);

}  // namespace mpmstudy
