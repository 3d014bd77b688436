#pragma once
/// The jobs of one study, each with the parameters and results that are asked for. Each call opens the
/// catalog read-only; all throw CatalogError.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runner/catalog/query.hpp"
#include "runner/catalog/records.hpp"

namespace mpmstudy {

/// Which jobs of a study, in the order of its sweep, and what of them.
struct JobRequest {
  std::string study;
  std::vector<std::string> parameters{};  ///< of a scene: "impact_speed"
  std::vector<std::string> results{};     ///< "collapsibility"; a name of libmpm/measure/results.hpp
  bool done_only = false;
  std::int64_t most = -1;  ///< rows; -1: all
  std::int64_t from = 0;   ///< the first of them
};

/// A result of one job; empty where it has none.
struct JobResult {
  std::optional<double> value;
  std::optional<double> error;  ///< half width of its interval
};

struct JobRow {
  std::string key;
  JobStatus status = JobStatus::planned;
  std::string outcome;               ///< "": none
  std::string flags;                 ///< why its final area has no meaning; "": it has one
  std::vector<SqlValue> parameters;  ///< a number or a word; null: its kind of scene has no such parameter
  std::vector<JobResult> results;
};
std::vector<JobRow> job_rows(const std::filesystem::path& results, const JobRequest&);

std::int64_t count_jobs(const std::filesystem::path& results, const std::string& study);

/// Why final areas of done jobs have no meaning, and of how many jobs; in the order of the sweep.
struct FlagCount {
  std::string flags;
  std::int64_t jobs = 0;
};
std::vector<FlagCount> flag_counts(const std::filesystem::path& results, const std::string& study);

/// The SQL that a person would ask for these rows with. Results that are no columns of the view `jobs` are
/// left out.
std::string readable_sql(const JobRequest&);

/// Jobs of a study that failed, coarser cells of its jobs too.
struct FailedJobs {
  struct Row {
    std::string key, kind, reason;
    std::vector<SqlValue> parameters;
  };
  std::int64_t count = 0;
  std::vector<Row> first;  ///< in the order of the sweep, coarse cells first
};
/// `parameters`: what every row has the value of; `most`: rows.
FailedJobs failed_jobs(const std::filesystem::path& results, const std::string& study,
                       const std::vector<std::string>& parameters, std::int64_t most);
/// The SQL that a person would ask for all of them with.
std::string readable_sql_of_failed();

/// Values of a parameter that the jobs of a study have, each once, ascending.
std::vector<double> parameter_values(const std::filesystem::path& results, const std::string& study,
                                     const std::string& parameter);

}  // namespace mpmstudy
