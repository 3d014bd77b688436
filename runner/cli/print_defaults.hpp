#pragma once
#include "runner/plan/plan.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Every parameter that the file leaves to the scene or to its material, a line per table; of bodies a line
/// for each of their materials, with all that is in force of it.
void print_defaults(const Study&, const Plan&);

}  // namespace mpmstudy
