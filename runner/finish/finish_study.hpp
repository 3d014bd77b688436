#pragma once
#include "runner/catalog/writer.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// What follows when all jobs of a study are decided: its fits go to the catalog, its figures to
/// results/figures. Prints the figures' paths, and fits that cannot be made. Throws what draw_figures throws.
void finish_study(const Study&, const std::filesystem::path& results, CatalogWriter&);

}  // namespace mpmstudy
