#pragma once
/// The scripts that Slurm runs. Pure.
#include <string>
#include <vector>

namespace mpmstudy {

struct SlurmScripts {
  std::string study;     ///< name
  std::string job_name;  ///< of the array, of no other job; its merge is called NAME-merge
  std::string clusters;  ///< that the options name, see clusters_of()
  std::string program;   ///< absolute path of mpmstudy
  std::string folder;    ///< of this submission, on the share: results/slurm/NAME-TIME
  std::string results;   ///< the results folder that shards are merged into
  std::size_t shards = 1;
  int workers = 1;                   ///< processors of an element
  int round = 1;                     ///< of the study: the merge submits the next one while work is left
  std::vector<std::string> run;      ///< options of `run` that hold for every element: --set, --timeout, ...
  std::vector<std::string> again;    ///< options of `run --engine slurm` for the next round
  std::vector<std::string> options;  ///< of sbatch, for both scripts: "--partition=long"
};

/// One element per shard. It works on a local disk; what is whole is moved to the share. Slurm may run an
/// element twice or again: the second one finds the shard there, or is dropped when it comes too late.
std::string array_script(const SlurmScripts&);

/// Takes over every shard that is whole, then goes on with the study: finishes it, or submits the next round.
std::string merge_script(const SlurmScripts&);

/// The clusters that options of sbatch name: "a,b" of --clusters=a,b or -M a,b; "": none.
std::string clusters_of(const std::vector<std::string>& options);

/// Why an option of sbatch, or the path of a results folder, cannot stand in a script; "": it can.
std::string wrong_option(const std::string&);
std::string wrong_path(const std::string&);

}  // namespace mpmstudy
