#pragma once
/// --set key=value: as if the study file said so.
#include <string>
#include <utility>
#include <vector>

#include "runner/study/document.hpp"
#include "runner/study/mistakes.hpp"

namespace mpmstudy {

/// Puts every override into the table that its key belongs to, over what the file says. A key that is another
/// name for something the file says (wall_thickness, cavity_center_height) takes its place.
void apply_overrides(Table& document, const std::vector<std::pair<std::string, std::string>>& set, Mistakes&);

}  // namespace mpmstudy
