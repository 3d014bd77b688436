#pragma once
#include <vector>

#include "analysis/raster.hpp"

namespace analysis {

/// Areas of the empty regions of an image that do not reach its border, the largest first [m^2]. Pixels that
/// share an edge are of one region.
std::vector<double> closed_empty_regions(const Raster&, const Window&);

}  // namespace analysis
