#pragma once
/// Which jobs of which studies a run takes.
#include <string>
#include <vector>

#include "runner/cli/run.hpp"
#include "runner/exec/study_run.hpp"

namespace mpmstudy {

/// One of every study, in their order; with --only a search is the list of what it may ask for. Throws
/// StudyError naming keys of --only that no study has.
std::vector<PlannedStudy> plan_studies(const RunOptions&, const std::vector<Study>&, const CostModel&);

/// Of --audit: "5 %", "5%" or "0.05". Throws StudyError.
double share_of(const std::string& text);

}  // namespace mpmstudy
