#pragma once
#include <filesystem>
#include <string>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// The jobs of a study that failed, coarser cells too, a line each of at most line_columns: its key, the
/// first line of the reason, and what sets it apart where no table has it (of a search, of a ladder of
/// cells). Then how many more there are, and which verbs go on from there. "": none failed. Throws
/// CatalogError.
std::string failures_text(const Study&, const std::filesystem::path& results);

/// " --results DIR" where that is not the default: for commands that a message names.
std::string results_option(const std::filesystem::path& results);

}  // namespace mpmstudy
