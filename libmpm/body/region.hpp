#pragma once
/// Sets of points that bodies fill, and what can be made of them:
///
///   const Region plate = block({0, 0}, {10e-6, 5e-6}) - disc({2e-6, 3e-6}, 1e-6);
///   const BasicRegion<3> bar = cylinder({0, 0, 0}, Axis::y, 32e-3, 3.2e-3) - ball<3>({0, 16e-3, 0}, 1e-3);
#include <functional>
#include <type_traits>
#include <vector>

#include "libmpm/core/tensor.hpp"

namespace mpm {

/// Heights low ... high on a vertical line, one along y [m].
struct Interval {
  double low, high;
};

/// Which vertical line: its x, and of three axes its (x, z) [m].
template <int axes>
using LineAt = std::conditional_t<axes == 2, double, Vec2>;

/// How much of a ball lies in a region. A ball of two axes is a disc.
enum class Share {
  all,
  none,
  part,  ///< some of it, or more than a quick look can tell
};

/// A region is given by its common points with balls and with vertical lines. Lengths in m.
template <int axes>
struct BasicRegion {
  Vec<axes> low, high;  ///< corners of a box that holds it; may be infinite
  std::function<Share(const Vec<axes>& center, double radius)> share_of_ball;
  /// Appends the intervals that the line has in common with the region: ascending, disjoint, some may be
  /// empty.
  std::function<void(const LineAt<axes>&, std::vector<Interval>&)> cut;
};
using Region = BasicRegion<2>;

template <int axes = 2>
BasicRegion<axes> everywhere();
template <int axes>
BasicRegion<axes> block(const Vec<axes>& low, const Vec<axes>& high);
template <int axes>
BasicRegion<axes> ball(const Vec<axes>& center, double radius);
/// `rotation`: of the ellipsoid about its centre; its half axes lie along x, y, z before.
template <int axes>
BasicRegion<axes> ellipsoid(const Vec<axes>& center, const Vec<axes>& half_axes,
                            const Mat<axes>& rotation = Mat<axes>::Identity());
/// The corners of a polygon in turn, either way round; at least three, and no two edges cross. Of three axes
/// the prism along z, which has no end.
template <int axes>
BasicRegion<axes> polygon(const std::vector<Vec2>& corners);
/// The side of the plane through `point` that `normal`, of any length, points away from.
template <int axes>
BasicRegion<axes> half_space(const Vec<axes>& point, const Vec<axes>& normal);

/// A rod from the centre of its one end to that of the other.
BasicRegion<3> cylinder(const Vec3& from, const Vec3& to, double radius);
enum class Axis { x, y, z };
inline BasicRegion<3> cylinder(const Vec3& from, Axis axis, double length, double radius) {
  return cylinder(from, from + length * Vec3::Unit(static_cast<int>(axis)), radius);
}

/// The words for two axes, which take braces.
inline Region block(Vec2 low, Vec2 high) { return block<2>(low, high); }
inline Region disc(Vec2 center, double radius) { return ball<2>(center, radius); }
inline Region ellipse(Vec2 center, Vec2 half_axes) { return ellipsoid<2>(center, half_axes); }

template <int axes>
BasicRegion<axes> operator-(BasicRegion<axes>,
                            BasicRegion<axes>);  ///< what is in the first and not in the second
template <int axes>
BasicRegion<axes> operator|(BasicRegion<axes>, BasicRegion<axes>);  ///< what is in one of them, or in both
template <int axes>
BasicRegion<axes> operator&(BasicRegion<axes>, BasicRegion<axes>);  ///< what is in both

}  // namespace mpm
