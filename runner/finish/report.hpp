#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "runner/finish/claims.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// One HTML page of everything that a catalog has on these studies: claims, then for each study the reading
/// it rests on (the comment at the head of its file), figures (drawn anew), animations of its snapshots, its
/// jobs with their errors, fits, brackets and costs. Every number is taken from the catalog as it is asked
/// for. Throws what draw_figures throws, and CatalogError.
std::string report_page(const std::vector<Study>&, const std::filesystem::path& results,
                        const std::vector<Claim>&);

}  // namespace mpmstudy
