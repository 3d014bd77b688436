#pragma once
/// What a submission's folder says about it: results/slurm/STUDY-TIME/submitted.json. It is there before
/// sbatch is asked, so whatever becomes of the asking, the job can be found by its name.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace mpmstudy {

struct SubmissionRecord {
  std::string study;
  std::string name;  ///< of the job array in Slurm, of no other; its merge is called NAME-merge
  std::size_t shards = 0;
  std::string clusters;            ///< of --clusters, where the options name some: where to ask
  std::string cluster;             ///< the one of the machine that submitted; "" where it was not known
  std::string user;                ///< who submitted
  std::int64_t asked_at = 0;       ///< when sbatch was about to be asked [s since 1970]
  std::string array_id, merge_id;  ///< of Slurm; "" until sbatch or squeue has said them
};

/// On disk when it returns. Throws CatalogError.
void write_record(const std::filesystem::path& folder, const SubmissionRecord&);

/// Nothing where the folder has none: nothing was submitted from it. Throws std::runtime_error with path and
/// cause for one that cannot be read.
std::optional<SubmissionRecord> read_record(const std::filesystem::path& folder);

/// The merge is done, or Slurm never had the job: nothing more is asked about it.
bool is_closed(const std::filesystem::path& folder);
void close_submission(const std::filesystem::path& folder);

/// Of whom this process is: "xu", or the number where it has no name.
std::string user_name();

}  // namespace mpmstudy
