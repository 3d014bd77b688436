#pragma once
#include <filesystem>
#include <vector>

#include "runner/finish/study_results.hpp"

namespace mpmstudy {

/// Draws every [[figure]] of the study from what is done, as results/figures/STUDY/NAME.png and .svg;
/// `fields` also in grey, for print, as NAME-grey. A figure for which nothing is done yet is left out.
/// Returns the PNG files. Every image carries the fingerprint of the rows it was drawn from and the physics
/// version. Throws std::runtime_error where gnuplot, a snapshot file or the disk fails.
std::vector<std::filesystem::path> draw_figures(const Study&, const StudyResults&);

/// Figures that are not among `drawn` (a calibration need not be), a line each: "figure area: there is
/// nothing to draw; results/figures/... is of an earlier run".
std::vector<std::string> not_drawn(const Study&, const std::vector<std::filesystem::path>& drawn,
                                   const std::filesystem::path& results);

/// What a reader of the figures and fits has to be told, a line each: numbers that are left out because they
/// have no meaning, characters of a title that no font has.
std::vector<std::string> figure_notes(const Study&, const StudyResults&);

}  // namespace mpmstudy
