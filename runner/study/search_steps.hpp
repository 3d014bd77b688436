#pragma once
#include <algorithm>
#include <cmath>

namespace mpmstudy {

/// A search of more steps most likely has a wrong unit: no two runs that are so close differ by more than
/// chance.
constexpr double most_search_steps = 100'000;

/// How many steps of at most `tolerance` go from lower to upper, lower < upper; as a double, because they
/// need not fit into an int.
inline double search_steps(double lower, double upper, double tolerance) {
  return std::max(1.0, std::ceil((upper - lower) / tolerance - 1e-9));
}

}  // namespace mpmstudy
