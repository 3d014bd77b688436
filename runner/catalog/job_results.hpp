#pragma once
/// What single jobs came to. Each call opens the catalog read-only; all throw CatalogError.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/simulation.hpp"
#include "runner/catalog/job_rows.hpp"
#include "runner/catalog/records.hpp"

namespace mpmstudy {

/// A done job of a study, and numbers that tell whether it is still the same one.
struct DoneJob {
  std::string key;
  std::optional<double> energy_error, final_area, final_area_error;
};
/// Each once, by key.
std::vector<DoneJob> done_jobs(const std::filesystem::path& results, const std::string& study);

/// Why the final area of a job has no meaning in this study, whose cells give it its interval; "": it has
/// one.
std::string flags_of_job(const std::filesystem::path& results, const std::string& study,
                         const std::string& key);

/// A result of libmpm/measure/results.hpp, or any metric, with the interval that this study gives it.
JobResult result_of_job(const std::filesystem::path& results, const std::string& study,
                        const std::string& key, const std::string& name);
/// SI, as the metrics of this name have it; "1" if no job has one.
std::string unit_of_metric(const std::filesystem::path& results, const std::string& name);

/// What a gauge of the job has seen; empty where it has none of that name.
mpm::History history_of_job(const std::filesystem::path& results, const std::string& key,
                            const std::string& gauge);
/// In order of time.
std::vector<mpm::AreaSample> area_history_of_job(const std::filesystem::path& results,
                                                 const std::string& key);
/// Relative to the results folder, in order of time.
std::vector<std::string> snapshot_paths(const std::filesystem::path& results, const std::string& key);
/// Every file of fields, by path: path, bytes and checksum alone.
std::vector<SnapshotFile> all_snapshots(const std::filesystem::path& results);

}  // namespace mpmstudy
