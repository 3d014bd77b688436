#pragma once
/// What is said before a run, or in place of one.
#include <vector>

#include "runner/cli/job_labels.hpp"
#include "runner/cli/run.hpp"
#include "runner/exec/study_run.hpp"

namespace mpmstudy {

/// --dry-run: what a run would do. Writes nothing, and needs no catalog. Gives back the exit code.
int print_intent(const RunOptions&, const std::vector<Study>&, const std::vector<PlannedStudy>&,
                 const CostModel&, const JobLabels&);

/// Says what the studies should know, and asks where they take more than this machine has. A search counts
/// with its points at their lower end. Throws StudyError if the answer is no.
void warn_and_ask(const RunOptions&, const std::vector<Study>&, const std::vector<PlannedStudy>&,
                  const CostModel&);

}  // namespace mpmstudy
