#pragma once
/// Short questions about jobs. Each opens the catalog read-only; all throw CatalogError.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"

namespace mpmstudy {

/// key -> status of every job of every study; empty where there is no catalog.
std::map<std::string, JobStatus> job_states(const std::filesystem::path& results);
/// How many jobs of a study are in which state, without coarser cells; only states that occur.
std::map<JobStatus, std::int64_t> counts_of(const std::filesystem::path& results, const std::string& study);
/// The jobs of a study that are in this state, in the order of its sweep.
std::vector<std::string> keys_of(const std::filesystem::path& results, const std::string& study, JobStatus);

/// A study that has a job, and why it asked for it.
struct Decision {
  std::string study, reason;  ///< reason "": an older program entered it
};
std::vector<Decision> decisions_of(const std::filesystem::path& results, const std::string& key);

/// A change of a job's state.
struct JobEvent {
  std::string at, from, to, by, reason;  ///< from "": the job is new
};
std::vector<JobEvent> events_of(const std::filesystem::path& results, const std::string& key);

}  // namespace mpmstudy
