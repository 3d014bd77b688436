#pragma once
#include <vector>

#include "libmpm/core/archive.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// The share of each node's cell that material fills: phi_i = sum V_p w_ip / (hx hy) with quadratic
/// B-splines, with images behind the mirrors and behind the impact wall; 1 inside the body, 0 in the void
/// [1].
struct Indicator {
  int columns, rows;             ///< nodes 0 ... columns, 0 ... rows
  Vec2 cell;                     ///< [m]
  std::vector<double> fraction;  ///< row by row

  double at(int i, int j) const { return fraction[static_cast<std::size_t>(j * (columns + 1) + i)]; }
};
Indicator indicator_of(const State&, int points_per_particle);

/// The cavity as the empty region (phi < 1/2) that is connected to where it was before.
///
/// Area: marching squares on phi, plus pi s^2 for a closed curve. phi is the material smeared by a kernel of
/// variance s^2 per axis, which shifts a curve of curvature k by s^2 k/2 towards its centre; around a closed
/// curve that takes pi s^2 from the area whatever its form (Gauss-Bonnet). s^2 = h^2 (1/4 + 1/6 - 1/(12
/// n^2)): B-spline, linear interpolation, and points (n a cell
/// edge) that stand for squares. A particle that is alone in its cell is split into four points: one would
/// leave steps in phi along the edge.
class VoidArea {
 public:
  /// `full_width`: the whole block is modelled, not half of it.
  VoidArea(Vec2 center, double radius, bool full_width, int particles_per_cell);

  /// Follows the region and returns its area [m^2]; 0 once it is gone.
  double update(const State&);
  /// Of its body of revolution about x = 0, in axisymmetry [m^3]. The shift of the curve takes
  /// pi s^2 integral r dtheta from it, theta the angle of the tangent: that of a circle, pi s^2 height.
  double volume() const { return volume_; }

  /// Empty regions of four nodes or more that reach neither free surface nor wall; this one is among them if
  /// it does not.
  int closed_regions() const { return closed_regions_; }
  /// The region reaches the free surface, or along the wall the gap under a body that leaves it: two cells
  /// beyond the first circle.
  bool joined_outside() const { return joined_outside_; }
  bool touches_wall() const { return touches_wall_; }  ///< the region reaches the impact wall
  void carry(Archive&);

 private:
  void seed(const Indicator&, const Vec2& origin, std::vector<char>& region) const;

  Vec2 center_;
  double radius_;
  bool full_width_;
  int points_per_particle_, points_per_cell_;
  bool started_ = false, joined_outside_ = false, touches_wall_ = false;
  int closed_regions_ = 0;
  double volume_ = 0;
  int previous_columns_ = 0, previous_rows_ = 0;
  std::vector<char> previous_;  ///< nodes of the region at the last update
};

}  // namespace mpm
