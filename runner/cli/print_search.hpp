#pragma once
#include <string>

#include "runner/exec/run_studies.hpp"
#include "runner/search/forecast.hpp"

namespace mpmstudy {

/// "search for the smallest impact_speed with outcome ejected, 200 m/s to 2 km/s in 18 steps at 2 points:
/// about 14 runs (12 to 16) in 7 rounds; which ones depends on what it finds".
std::string readable_forecast(const Study&, const SearchForecast&);

/// The brackets of a search that has ended, a line each, and what its audit found.
void print_search(const Study&, const SearchReport&);

}  // namespace mpmstudy
