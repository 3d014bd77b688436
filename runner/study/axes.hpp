#pragma once
/// What the axes of a study say together, and what --cells makes of one.
#include <vector>

#include "libmpm/space/space.hpp"
#include "runner/study/axis.hpp"

namespace mpmstudy {

/// Adds a mistake for rows that are expressions of each other. Those of the study's own are found when their
/// units are.
void refuse_cycles(const std::vector<Axis>&, Mistakes&);

/// Times --cells, to 12 digits, as a file would say it. Adds a mistake where that is no cell.
void scale_cells(Axis&, double factor, Mistakes&);

/// Whether some jobs may decide ejection: the file says so, or (`seeks_ejection`) its search is for it.
bool may_decide_ejection(const std::vector<Axis>&, bool seeks_ejection);

/// Of the jobs, in the order of the file.
std::vector<mpm::Space> spaces_of(const std::vector<Axis>&);

}  // namespace mpmstudy
