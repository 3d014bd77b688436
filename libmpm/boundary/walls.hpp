#pragma once
/// What walls do to the nodes of a grid: one text for the plain step and the fast one. The rules, with their
/// sources, are in mirror.hpp and impact_wall.hpp.
///
/// `Nodes` gives access to a grid of two axes, or to a slice of one of three, in which layers of nodes lie
/// behind the walls:
///   nodes.at(i, j)               a WallNode; i across the sides, j from the floor upwards
///   nodes.leave_heat(i, j, h)    h [J/kg]: what the contact took from the motion of the node
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace mpm::walls {

/// A node by its axes. Before the grid update v is momentum and a force, after it they are velocity and rate.
template <class Real, int axes = 2>
struct WallNode {
  Real& mass;
  std::array<Real*, axes> v;
  std::array<Real*, axes> a;
};

/// A node on the mirror across `axis`: it and its image are one, of twice the mass, momentum and force.
template <class Real, int axes>
void stop(const WallNode<Real, axes>& n, int axis) {
  n.mass *= 2;
  for (int k = 0; k < axes; ++k) *n.v[k] *= 2, *n.a[k] *= 2;
  *n.v[axis] = *n.a[axis] = 0;
}

/// Adds to each of two nodes the image of the other.
template <class Real, int axes>
void join(const WallNode<Real, axes>& n, const WallNode<Real, axes>& image, int axis) {
  image.mass = n.mass += image.mass;
  for (int k = 0; k < axes; ++k) {
    const Real sign = k == axis ? -1 : 1;
    *image.v[k] = sign * (*n.v[k] += sign * *image.v[k]);
    *image.a[k] = sign * (*n.a[k] += sign * *image.a[k]);
  }
}

/// Mirrors at the columns 0 and `right`, for the rows [first, last] and `layers` of nodes behind them.
/// `axis`: the one that columns are counted along.
template <class Nodes>
void reflect_sides(Nodes nodes, int right, int first, int last, int layers, int axis = 0) {
  for (int j = first; j <= last; ++j)
    for (const int wall : {0, right}) {
      const int inwards = wall == 0 ? 1 : -1;
      stop(nodes.at(wall, j), axis);
      for (int k = 1; k <= layers; ++k)
        join(nodes.at(wall + inwards * k, j), nodes.at(wall - inwards * k, j), axis);
    }
}

/// A mirror along `row`, for the columns [first, last] and `layers` of rows below it.
template <class Nodes>
void reflect_row(Nodes nodes, int row, int first, int last, int layers) {
  for (int i = first; i <= last; ++i) {
    stop(nodes.at(i, row), 1);
    for (int k = 1; k <= layers; ++k) join(nodes.at(i, row + k), nodes.at(i, row - k), 1);
  }
}

/// Whether there is mass in column 0, which stands for an open left side, or in column `right`, for an open
/// right one. `has_mass`: of node (i, j).
template <class HasMass>
bool at_sides(const HasMass& has_mass, bool left, bool right_is_open, int right, int first, int last) {
  if (!left && !right_is_open) return false;
  for (int j = first; j <= last; ++j)
    if ((left && has_mass(0, j)) || (right_is_open && has_mass(right, j))) return true;
  return false;
}

/// Whether there is mass in row 0, up to column `right`.
template <class HasMass>
bool at_floor(const HasMass& has_mass, int right) {
  for (int i = 0; i <= right; ++i)
    if (has_mass(i, 0)) return true;
  return false;
}

/// Whether there is mass at an open face: `sides` as of OpenSides (boundary/mirror.hpp), the rows [first,
/// last], and the floor where it is open. `has_mass`: of node (i, j, k); of two axes `slices` and k are 0,
/// and there is no front and no back.
template <class Sides, class HasMass>
bool at_open_face(const HasMass& has_mass, const Sides& sides, bool floor_is_open, int columns, int slices,
                  int first, int last) {
  for (int k = 0; k <= slices; ++k) {
    const auto in_slice = [&](int i, int j) { return has_mass(i, j, k); };
    if (at_sides(in_slice, sides.left, sides.right, columns, first, last) ||
        (floor_is_open && at_floor(in_slice, columns)))
      return true;
  }
  if (slices == 0 || (!sides.front && !sides.back)) return false;
  for (int i = 0; i <= columns; ++i)
    if (at_sides([&](int k, int j) { return has_mass(i, j, k); }, sides.front, sides.back, slices, first,
                 last))
      return true;
  return false;
}

/// Gives a node another velocity. a is the change of v over `step`.
template <class Nodes, class Velocity, class Real>
void move_to(Nodes nodes, int i, int j, const Velocity& velocity, Real step) {
  const auto n = nodes.at(i, j);
  const Real half = Real(0.5) * step;
  Real gain = 0;
  for (std::size_t k = 0; k < velocity.size(); ++k) {
    const Real change = velocity[k] - *n.v[k];
    *n.v[k] = velocity[k];
    *n.a[k] += change / step;
    const Real part = change * (velocity[k] - half * *n.a[k]);
    gain = k == 0 ? part : gain + part;
  }
  nodes.leave_heat(i, j, -gain);
}

/// The gaps between the impact wall and the body above each column, where they are tracked (impact_wall.hpp).
struct ColumnGaps {
  double* of_first = nullptr;  ///< of the first column [m]; null: they are not
  double dt = 0;               ///< the time step [s]
};

/// Those of slice number `slice` of `slices`, each of so many columns. Of an empty vector makes zeros.
inline ColumnGaps gaps_of_slice(std::vector<double>* all, int columns, int slices, int slice, double dt) {
  if (!all) return {};
  const auto count = static_cast<std::size_t>(columns);
  if (all->empty()) all->assign(count * static_cast<std::size_t>(slices), 0);
  return {all->data() + count * static_cast<std::size_t>(slice), dt};
}

/// The impact wall along row 0, for the columns [first, last] and `layers` of rows on either side. `step`:
/// the time over which v changes by a; 1 where a is the change itself.
template <class Real, class Nodes>
void push_off_wall(Nodes nodes, int first, int last, int layers, Real step, ColumnGaps gaps = {}) {
  constexpr std::size_t normal = 1;
  for (int i = first; i <= last; ++i) {
    const auto wall = nodes.at(i, 0);
    if (wall.mass == 0) continue;
    // the velocity of the common momentum of a node above the wall and the image of the one below
    const auto common = [&](int k, std::size_t axis) {
      const auto above = nodes.at(i, k), below = nodes.at(i, -k);
      if (!(below.mass > 0)) return *above.v[axis];
      const Real image = axis == normal ? -*below.v[axis] : *below.v[axis];
      return (above.mass * *above.v[axis] + below.mass * image) / (above.mass + below.mass);
    };
    Real push = -(wall.mass * *wall.v[normal]), mass = wall.mass;
    for (int k = 1; k <= layers; ++k) {
      const auto above = nodes.at(i, k), below = nodes.at(i, -k);
      const Real y = common(k, normal);
      push = above.mass * (y - *above.v[normal]) + push + below.mass * (-y - *below.v[normal]);
      if (below.mass > 0) mass += 4 * (above.mass * below.mass / (above.mass + below.mass));
    }
    if (gaps.of_first) {
      double& gap = gaps.of_first[i - first];
      gap -= gaps.dt * static_cast<double>(push / mass);
      if (gap > 0) continue;
      gap = 0;
    }
    if (!(push > 0)) continue;
    std::array<Real, std::tuple_size_v<decltype(wall.v)>> velocity;
    for (std::size_t axis = 0; axis < velocity.size(); ++axis)
      velocity[axis] = axis == normal ? Real(0) : *wall.v[axis];
    move_to(nodes, i, 0, velocity, step);
    for (int k = 1; k <= layers; ++k) {
      if (nodes.at(i, k).mass == 0 && nodes.at(i, -k).mass == 0) continue;
      for (std::size_t axis = 0; axis < velocity.size(); ++axis) velocity[axis] = common(k, axis);
      move_to(nodes, i, k, velocity, step);
      velocity[normal] = -velocity[normal];
      move_to(nodes, i, -k, velocity, step);
    }
  }
}

}  // namespace mpm::walls
