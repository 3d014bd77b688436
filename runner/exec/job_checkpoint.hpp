#pragma once
/// The checkpoint of a job, fields/KEY/checkpoint.h5: what its run holds, and what the job has left so far.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/core/archive.hpp"
#include "runner/catalog/field_files.hpp"
#include "runner/catalog/records.hpp"

namespace mpmstudy {

struct JobCheckpoint {
  mpm::Record run;
  std::vector<SnapshotFile> files;  ///< written before it
  double wall_s = 0, cpu_s = 0;     ///< spent before it [s]
};

/// Replaces the one that is there. Throws std::runtime_error naming path and cause.
void write_job_checkpoint(const std::filesystem::path&, JobCheckpoint);

/// Empty if there is none. Empty, and `why_not` says why, if it cannot be read, was written by another
/// program, or if a file that it counts on, under `results`, is not as it was written: then the job begins
/// anew.
std::optional<JobCheckpoint> read_job_checkpoint(const std::filesystem::path&,
                                                 const std::filesystem::path& results, std::string& why_not);

}  // namespace mpmstudy
