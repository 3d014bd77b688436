#pragma once
#include <filesystem>
#include <string>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// The jobs of a study that failed, a line each: its key, of a search also what sets it apart (the other jobs
/// of a search are in no table), and the first line of the reason, in all line_columns at most. Then how many
/// more there are, and which verbs go on from there. "": none failed. Throws CatalogError.
std::string failures_text(const Study&, const std::filesystem::path& results);

/// " --results DIR" where that is not the default: for commands that a message names.
std::string results_option(const std::filesystem::path& results);

}  // namespace mpmstudy
