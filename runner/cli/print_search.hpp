#pragma once
#include "runner/exec/run_search.hpp"

namespace mpmstudy {

/// The brackets of a search that has ended, a line each, and what its audit found.
void print_search(const Study&, const SearchReport&);

}  // namespace mpmstudy
