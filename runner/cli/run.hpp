#pragma once
/// `mpmstudy run STUDY...`: runs what is not decided yet. Running again goes on.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runner/catalog/writer.hpp"
#include "runner/cli/cli.hpp"
#include "runner/exec/executor.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Of --engine slurm.
struct SlurmOptions {
  std::vector<std::string> options;   ///< of sbatch, "--partition=long"
  std::string shard_time = "30 min";  ///< predicted time of a shard
  int most_shards = 1000;
  int round = 1;   ///< which one this is
  int rounds = 5;  ///< after which what is left is left
};

struct RunOptions {
  std::vector<std::string> files;
  std::string results;
  StudyOptions study;
  int workers = 0;               ///< 0: as many as there are processors
  std::string engine = "local";  ///< or "slurm"
  SlurmOptions slurm;
  std::string only;    ///< a file of keys: run no other jobs; "": all
  bool shard = false;  ///< with `only`: a catalog of these jobs alone, which is merged into another one
  bool dry_run = false;
  bool retry_failed = false;
  int retries = 0;                  ///< how often a failed job is run again
  std::string timeout;              ///< of a job, "10 min"; "": none
  std::string memory;               ///< of a job, "2 GB"; "": none
  std::string checkpoint = "60 s";  ///< processor time between checkpoints of a job; "0": none
  std::string heartbeat = "5 s";    ///< period of signs of life
  std::string budget;               ///< wall time after which no job is started, "2 h"; "": none
  bool quiet = false;
  bool verbose = false;
  bool json = false;          ///< standard output is one JSON object: what the studies have come to
  std::string audit = "0 %";  ///< share of the early stops of a search that is run to the end
};

/// What follows when all jobs of a study are decided: fits, figures. It reads the catalog of `results`
/// (query() of catalog/query.hpp) and hands fits to the writer. What it throws is printed, and the run ends
/// with 1.
using FinishStudy = std::function<void(const Study&, const std::filesystem::path& results, CatalogWriter&)>;

/// What main puts behind the verb: mpm::run, mpm::write_vtkhdf, fits and figures.
struct RunSeams {
  Simulate simulate;
  WriteSnapshot write_snapshot;
  FinishStudy finish_study;  ///< empty: nothing follows
};

void setup_run(CLI::App&, RunSeams);
/// Throws StudyError and CatalogError before anything has run.
int run_run(const RunOptions&, const RunSeams&);

}  // namespace mpmstudy
