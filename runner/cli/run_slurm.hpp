#pragma once
/// `mpmstudy run STUDY --engine slurm`: the jobs of a study as a job array, and a merge that depends on it.
#include <vector>

#include "runner/cli/run.hpp"
#include "runner/exec/run_studies.hpp"

namespace mpmstudy {

/// Registers the study, deals its open jobs out to shards, submits; --dry-run prints the scripts and writes
/// nothing. Jobs that are in the queue already, or may be there, are left there. Before that it sees to
/// earlier submissions: a merge that is lost is asked for again, an array that has ended without one is taken
/// over. exit_ok when all that is left is in the queue for sure, or nothing is left; exit_failed when all is
/// decided and some jobs failed; exit_stopped when work is left that is not in the queue for sure: --rounds
/// are over, sbatch refuses, Slurm does not answer.
/// Of a search, and of ladders that climb, each submission is one round, and its merge submits the next.
int run_on_slurm(const RunOptions&, const Study&, const PlannedStudy&, const RunSeams&);

}  // namespace mpmstudy
