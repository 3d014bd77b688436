#pragma once
/// What predict and sensitivity say of the surfaces that they ask.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/finish/surface.hpp"

namespace mpmstudy {

/// The results to make surfaces of: those that are named, else those of the study's fits and figures. Throws
/// StudyError.
std::vector<std::string> results_to_show(const Study&, const std::vector<std::string>& named);
/// "0.137 µm², 0.0566 to 0.218": an estimate and the ends of its interval, in one unit; `between`: before the
/// ends.
std::string interval_text(const Estimate&, const std::string& si_unit, const char* between);
/// "  from 24 runs; each left out: error 0.031 (rms) ...": what a surface is worth.
std::string quality_text(const ResultSurface&);
/// The same for programs: runs, left_out_rms, left_out_q2, left_out_covered.
nlohmann::ordered_json quality_json(const ResultSurface&);

/// Whether the tolerance of a study's [surface] holds, and by how many runs; "" without one. Throws
/// CatalogError.
std::string tolerance_text(const Study&, const std::filesystem::path& results);
/// The same for programs: of, runs, budget, tolerance, share, holds, failure; null without one.
nlohmann::ordered_json tolerance_json(const Study&, const std::filesystem::path& results);

}  // namespace mpmstudy
