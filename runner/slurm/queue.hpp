#pragma once
/// What of a results folder is in the queue of a Slurm. Asks `squeue`; where there is none, nothing is known
/// to be in the queue.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "runner/slurm/script.hpp"

namespace mpmstudy {

/// A job array of this results folder that is not merged yet.
struct Submission {
  std::filesystem::path folder;
  std::string study;
  std::string array_id, merge_id;  ///< of Slurm
  std::size_t shards = 0;
  std::size_t whole = 0;                 ///< shards that are on the share
  std::size_t pending = 0, running = 0;  ///< elements in the queue
  std::size_t held = 0;                  ///< of the pending: someone has held them
  std::vector<std::string> stranded;     ///< of the held: Slurm could not start them and asks for a human
  bool merge_queued = false;

  bool in_queue() const { return pending + running > 0 || merge_queued; }
};

/// Oldest first.
std::vector<Submission> read_submissions(const std::filesystem::path& results);

/// Lets Slurm try again what is stranded; the ids that it took back.
std::vector<std::string> release_stranded(const std::vector<Submission>&);

/// Keys of the newest submission of a study, merged or not.
std::set<std::string> last_submitted(const std::filesystem::path& results, const std::string& study);

/// Keys of the jobs whose submission is still in the queue.
std::set<std::string> queued_keys(const std::vector<Submission>&);

/// Writes scripts and keys to scripts.folder, submits the array and the merge that depends on it. `keys`: of
/// every shard. `study_file` is copied. Throws std::runtime_error with what sbatch says; nothing is left
/// then.
Submission submit(const SlurmScripts& scripts, const std::filesystem::path& study_file,
                  const std::vector<std::vector<std::string>>& keys);

}  // namespace mpmstudy
