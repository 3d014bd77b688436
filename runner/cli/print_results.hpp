#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// What a study has come to, as `run` ends with it: one row per job with what the study sweeps, its results
/// with the half width of their intervals, and the outcome; of more than 30 jobs the first and the last ones,
/// and the query that has them all. Numbers that have a flag (view `jobs`) are marked, and a line below says
/// why. Then the jobs that failed, with the first line of their reason, and the fits with the captions of
/// their figures. No line is longer than line_columns, but for queries and
/// captions. Throws CatalogError.
std::string results_text(const Study&, const std::filesystem::path& results);

/// The headline of the scene, then what the study's fits and figures show and what its gauges come to (their
/// reductions, or the value at the end), each once; no more than `most`.
std::vector<std::string> results_of_interest(const Study&, std::size_t most);

/// The brackets that the catalog has of a study with [search], a line each.
std::string brackets_text(const Study&, const std::filesystem::path& results);

/// The fits of a study, a line each with the caption of its figure; also why there is none.
std::string fits_text(const Study&, const std::filesystem::path& results);

}  // namespace mpmstudy
