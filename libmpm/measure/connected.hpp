#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "libmpm/core/tensor.hpp"

namespace mpm {

/// The parts of a body that hang together.
struct ConnectedParts {
  std::vector<int> part;  ///< of each point, 0 ... count - 1, numbered in the order of the points
  int count = 0;
};

/// Two points less than `link` apart are linked, and all that links join are one part. In MPM particles feel
/// each other through the nodes they share, so with link = one cell what is apart has parted, up to about a
/// cell. Cost: linear in the points; most links are found between square or cubic bins of link / sqrt(axes),
/// in which all points are linked. `axes` is 2 or 3. Checked by tests/libmpm/ejection_test.cpp against all
/// pairs.
template <int axes>
ConnectedParts connected_parts(std::span<const Vec<axes>> points, double link);

}  // namespace mpm
