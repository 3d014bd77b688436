#pragma once
#include <cstddef>

#include "runner/study/mistakes.hpp"

namespace mpmstudy {

/// Refuses two figures that would be one file: of kind "fields" each has NAME-1, NAME-2, ... (NAME where
/// there is one job), and these with -grey. `document`: one whose figures have been read without a mistake.
void check_figure_files(const Table& document, std::size_t jobs, Mistakes&);

}  // namespace mpmstudy
