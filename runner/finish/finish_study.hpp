#pragma once
#include "runner/catalog/writer.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// What follows when all jobs of a study are decided: its intervals and fits go to the catalog, its figures
/// to results/figures. Prints the figures' paths, and fits that cannot be made. Throws what draw_figures
/// throws, and std::runtime_error at the end if an accuracy was not reached or a fit or a figure could not be
/// made.
void finish_study(const Study&, const std::filesystem::path& results, CatalogWriter&);

}  // namespace mpmstudy
