#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "libmpm/core/archive.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// The share of each node's cell that material fills: phi_i = sum V_p w_ip / (hx hy) with quadratic
/// B-splines, with images behind the mirrors and behind the impact wall; 1 inside the body, 0 in the void
/// [1]. Of three axes V_p is a volume, and hz divides, too.
template <int axes>
struct BasicIndicator {
  using Node = std::array<int, axes>;  ///< along x, then z if there is one, then y: in the order of memory

  Node last;                     ///< nodes 0 ... last
  Vec<axes> cell;                ///< [m]
  std::vector<double> fraction;  ///< row by row

  int nodes(int axis) const { return last[static_cast<std::size_t>(axis)] + 1; }
  std::size_t index(const Node& n) const {
    std::size_t index = 0;
    for (int axis = axes - 1; axis >= 0; --axis)
      index = index * static_cast<std::size_t>(nodes(axis)) +
              static_cast<std::size_t>(n[static_cast<std::size_t>(axis)]);
    return index;
  }
  Node node(std::size_t index) const {
    Node n;
    for (int axis = 0; axis < axes; ++axis) {
      const auto count = static_cast<std::size_t>(nodes(axis));
      n[static_cast<std::size_t>(axis)] = static_cast<int>(index % count);
      index /= count;
    }
    return n;
  }
  int rows() const { return last[axes - 1]; }
  bool empty(std::size_t index) const { return fraction[index] < 0.5; }
};
template <int axes>
BasicIndicator<axes> indicator_of(const BasicState<axes>&, int points_per_particle);

/// The cavity as the empty region (phi < 1/2) that is connected to where it was before.
///
/// Area: marching squares on phi, plus pi s^2 for a closed curve. phi is the material smeared by a kernel of
/// variance s^2 per axis, which shifts a curve of curvature k by s^2 k/2 towards its centre; around a closed
/// curve that takes pi s^2 from the area whatever its form (Gauss-Bonnet). s^2 = h^2 (1/4 + 1/6 - 1/(12
/// n^2)): B-spline, linear interpolation, and points (n a cell
/// edge) that stand for squares. A particle that is alone in its cell is split into four points: one would
/// leave steps in phi along the edge.
///
/// Of three axes the volume is that below 1/2 in the six tetrahedra of each cell, phi linear in each. The
/// shift is s^2 (k1 + k2)/2, and takes s^2 M from the volume, M the integral of the mean curvature: 2 pi
/// times the mean width of a convex body, for which the mean of its three extents stands. The area is that of
/// the section z = 0, whose second curvature is taken for the first: 2 pi s^2. Both hold for a sphere. A
/// particle that is alone is split into eight. Checked by tests/libmpm/area_test.cpp: 0.2 % on 30 cells
/// across.
template <int axes>
class BasicVoidArea {
 public:
  /// `full`: the whole block is modelled, not half of it (of three axes a quarter).
  BasicVoidArea(const Vec<axes>& center, double radius, bool full, int particles_per_cell);

  /// Follows the region and returns its area [m^2]; 0 once it is gone.
  double update(const BasicState<axes>&);
  /// In axisymmetry of its body of revolution about x = 0 [m^3]: the shift of the curve takes
  /// pi s^2 integral r dtheta from it, theta the angle of the tangent: that of a circle, pi s^2 height.
  /// Of three axes its own.
  double volume() const { return volume_; }

  /// Empty regions of four nodes or more (of three axes eight) that reach neither free surface nor wall; this
  /// one is among them if it does not.
  int closed_regions() const { return closed_regions_; }
  /// The region reaches the free surface, or along the wall the gap under a body that leaves it: two cells
  /// beyond the first circle.
  bool joined_outside() const { return joined_outside_; }
  bool touches_wall() const { return touches_wall_; }  ///< the region reaches the impact wall
  void carry(Archive&);

 private:
  using Indicator = BasicIndicator<axes>;

  void seed(const Indicator&, const Vec<axes>& origin, std::vector<char>& region) const;
  double measure(const Indicator&, const std::vector<char>& region, double variance, double closed);

  Vec<axes> center_;
  double radius_;
  bool full_;
  int points_per_particle_, points_per_edge_square_;
  bool started_ = false, joined_outside_ = false, touches_wall_ = false;
  int closed_regions_ = 0;
  double volume_ = 0;
  std::vector<char> previous_;  ///< nodes of the region at the last update
};
using VoidArea = BasicVoidArea<2>;

}  // namespace mpm
