#pragma once
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/search/search.hpp"

namespace mpmstudy {

/// Rows of the catalog; what is extrapolated stands on the finest cell of each ladder. A point without a
/// bracket has a row, too: its ends are null and its flags say why.
std::vector<BracketRow> bracket_rows(const Study&, const std::vector<FoundBracket>&);

}  // namespace mpmstudy
