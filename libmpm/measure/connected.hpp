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
/// cell. Cost: linear in the points; most links are found between square bins of link / sqrt(2), in which all
/// points are linked. Checked by tests/libmpm/ejection_test.cpp against all pairs.
ConnectedParts connected_parts(std::span<const Vec2> points, double link);

}  // namespace mpm
