#pragma once
/// What of a results folder is in the queue of a Slurm. Where Slurm gives no answer that is not known, and
/// nothing is submitted that may be in the queue.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "runner/slurm/record.hpp"

namespace mpmstudy {

/// A job array of this results folder that is not merged yet.
struct Submission {
  std::filesystem::path folder;
  SubmissionRecord record;
  std::string unknown;                   ///< why it is not known what of it is in the queue; "": it is known
  std::size_t whole = 0;                 ///< shards that are on the share
  std::size_t pending = 0, running = 0;  ///< elements in the queue
  std::size_t held = 0;                  ///< of the pending: someone has held them
  std::vector<std::string>
      stranded;  ///< of the held: Slurm could not start them and waits for a command of a user
  bool merge_queued = false;
  bool unmerged =
      false;  ///< it has ended, and its shards could not be taken over: they wait for the next run

  bool array_queued() const { return pending + running > 0; }
  /// Some of it is in the queue, or may be.
  bool may_be_queued() const { return !unknown.empty() || array_queued() || merge_queued; }
};

/// How long after sbatch was asked Slurm may still take the job although nobody has seen it yet [s].
inline constexpr std::int64_t may_still_be_taken_s = 300;

/// Oldest first. Asks squeue by the names of the jobs; numbers that it gives and the record has not are
/// recorded.
std::vector<Submission> read_submissions(const std::filesystem::path& results);

/// Asks squeue about one submission (see read_submissions).
void ask_queue(Submission&);

/// Keys of the jobs of a submission.
std::set<std::string> keys_of(const Submission&);

/// Keys of the jobs whose submission is still in the queue, or may be.
std::set<std::string> queued_keys(const std::vector<Submission>&);

/// Keys of the newest submission of a study, merged or not.
std::set<std::string> last_submitted(const std::filesystem::path& results, const std::string& study);

/// The folders of its shards that are whole.
std::vector<std::filesystem::path> whole_shards(const Submission&);

struct Released {
  std::vector<std::string> ids;       ///< that Slurm took back
  std::vector<std::string> refusals;  ///< "4711_3: what scontrol said"
};

/// Releases what is stranded, so that Slurm tries it again.
Released release_stranded(const std::vector<Submission>&);

}  // namespace mpmstudy
