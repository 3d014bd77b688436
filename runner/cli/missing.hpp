#pragma once
#include <string>

#include "runner/finish/study_results.hpp"

namespace mpmstudy {

/// Says on stderr, in a line or two, what of a study the catalog does not have, why, and what to do; and
/// which numbers figures leave out. `again`: what to type after `mpmstudy run`. Gives back the exit code:
/// exit_ok where all is done, exit_failed where jobs failed and nothing else is left, exit_stopped where
/// something is to run.
int say_what_is_missing(const Study&, const StudyResults&, const std::string& again);

}  // namespace mpmstudy
