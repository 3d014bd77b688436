#pragma once
/// `mpmstudy run STUDY --engine slurm`: the jobs of a study as a job array, and a merge that depends on it.
#include <vector>

#include "runner/cli/run.hpp"
#include "runner/exec/run_search.hpp"

namespace mpmstudy {

/// Registers the study, deals its open jobs out to shards, submits; --dry-run prints the scripts and writes
/// nothing. Jobs that are in the queue already are left there. exit_ok when all is submitted or done;
/// exit_stopped when work is left and --rounds are over, or sbatch refuses.
int run_on_slurm(const RunOptions&, const Study&, const PlannedStudy&, const RunSeams&);

/// The same for a study with [search]: each submission is one round of it, and its merge submits the next.
int search_on_slurm(const RunOptions&, const Study&, const SearchOptions&, const RunSeams&);

}  // namespace mpmstudy
