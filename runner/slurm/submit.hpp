#pragma once
/// Hands a job array and its merge to Slurm, so that no job is ever in the queue unknown to the results
/// folder.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/slurm/queue.hpp"
#include "runner/slurm/script.hpp"

namespace mpmstudy {

/// What the elements of an array read.
struct StudyFiles {
  std::filesystem::path study;
  std::filesystem::path points;  ///< from the folder of the study, or absolute; empty: none
};

struct SubmitOutcome {
  Submission submission;
  std::vector<std::string> notes;  ///< what sbatch said beside the numbers
  std::string trouble;             ///< why not all of it is in the queue for sure; "": it is
  bool folder_kept = true;         ///< false: Slurm refused, and nothing is left
};

/// Writes the scripts, the keys of every shard, copies of the study and its points, and the record to
/// scripts.folder, then asks sbatch for the array and for the merge that depends on it. Where sbatch fails,
/// squeue is asked whether Slurm took the job all the same. The folder goes only when Slurm has refused and
/// does not know the job. Nothing that Slurm has taken is cancelled: a merge that it refuses is asked for
/// again by the next run. Throws std::runtime_error where the folder cannot be written; nothing is submitted
/// then.
SubmitOutcome submit(const SlurmScripts& scripts, const StudyFiles&,
                     const std::vector<std::vector<std::string>>& keys);

/// Asks again for the merge of an array that is in the queue. What is wrong, or "".
std::string submit_merge(Submission&, std::vector<std::string>& notes);

/// Holds off other programs that submit from this results folder, as far as its file system knows locks.
class SubmitLock {
 public:
  explicit SubmitLock(const std::filesystem::path& results);
  ~SubmitLock();
  SubmitLock(const SubmitLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace mpmstudy
