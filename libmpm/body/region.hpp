#pragma once
/// Sets of points of the plane that bodies fill, and what can be made of them:
///
///   const Region plate = block({0, 0}, {10e-6, 5e-6}) - disc({2e-6, 3e-6}, 1e-6);
#include <functional>
#include <vector>

#include "libmpm/core/tensor.hpp"

namespace mpm {

/// Heights low ... high on a vertical line [m].
struct Interval {
  double low, high;
};

/// How much of a circle lies in a region.
enum class Share {
  all,
  none,
  part,  ///< some of it, or more than a quick look can tell
};

/// A region is given by its common points with circles and with vertical lines. Lengths in m.
struct Region {
  Vec2 low, high;  ///< corners of a rectangle that holds it; may be infinite
  std::function<Share(const Vec2& center, double radius)> share_of_circle;
  /// Appends the intervals that the line at x has in common with the region: ascending, disjoint, some may
  /// be empty.
  std::function<void(double x, std::vector<Interval>&)> cut;
};

Region everywhere();
Region block(Vec2 low, Vec2 high);  ///< a rectangle
Region disc(Vec2 center, double radius);
Region ellipse(Vec2 center, Vec2 half_axes);

Region operator-(Region, Region);  ///< what is in the first and not in the second
Region operator|(Region, Region);  ///< what is in one of them, or in both

}  // namespace mpm
