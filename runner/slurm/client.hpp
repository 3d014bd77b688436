#pragma once
/// What the commands of Slurm answer. An exit code, an error, a notice in place of an answer, or no answer in
/// time means "not known", never "nothing there".
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mpmstudy {

struct QueueRow {
  std::string id;     ///< "1234_5" or "1234"
  std::string state;  ///< as squeue abbreviates it: "PD", "R", "CD", ...
  std::string name;   ///< of the job
  std::string reason;

  std::string array_id() const { return id.substr(0, id.find('_')); }
  /// Ended in any way: completed, failed, cancelled, out of time, ...; a state that is not known has not.
  bool ended() const;
};

struct QueueAnswer {
  std::vector<QueueRow> rows;
  bool no_such_job = false;  ///< it says that it has no job of this number (any longer)
  std::string unknown;       ///< why there is no answer; "": there is one
};

/// Asks for jobs by their names, or by their numbers: "a,b". Those that have ended are told, too, as long as
/// Slurm keeps their records. `clusters`: of --clusters; "": the one that this machine belongs to.
QueueAnswer queue_by_name(const std::string& names, const std::string& clusters);
QueueAnswer queue_by_id(const std::string& ids, const std::string& clusters);

/// The answer in what squeue printed; nothing unless the line of titles is there: without it the rest may be
/// anybody's notice. Pure.
std::optional<std::vector<QueueRow>> parse_queue(std::string_view printed);

struct JobNumber {
  std::string id, cluster;  ///< cluster: "" unless `sbatch` names one
};

/// The last line that is NUMBER or NUMBER;CLUSTER, as `sbatch --parsable` prints it, or "Submitted batch job
/// NUMBER on cluster CLUSTER", as it prints it where a wrapper has dropped --parsable. Pure.
std::optional<JobNumber> parse_job_number(std::string_view printed);

struct SubmitAnswer {
  std::optional<JobNumber> taken;
  bool never_asked = false;  ///< there is no sbatch here
  bool refused = false;  ///< it has said no; else, with nothing taken, Slurm may have the job all the same
  std::string words;     ///< what sbatch said beside the number
};

/// `sbatch --parsable --job-name=NAME OPTIONS... SCRIPT`.
SubmitAnswer sbatch(const std::string& name, const std::vector<std::string>& options,
                    const std::string& script);

/// What scontrol says where it refuses; "": the element is released.
std::string release_job(const std::string& id, const std::string& clusters);

struct SlurmConfig {
  std::string cluster;        ///< "" where it is not known
  bool jobs_private = false;  ///< users do not see each other's jobs
};
SlurmConfig slurm_config();

}  // namespace mpmstudy
