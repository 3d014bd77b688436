#include "libmpm/step/fast/node_grid.hpp"

#include <algorithm>
#include <cmath>

namespace mpm::fast {
namespace {
constexpr int spare_rows = 4;  ///< that a step may climb; more than a cell is a breakdown anyway
}  // namespace

template <class Real>
NodeGrid<Real>::NodeGrid(int columns) {
  constexpr int width = Nodes<Real>::width;
  nodes_.columns = columns;
  nodes_.stride = (columns + 3 + width - 1) / width * width;  // with two ghosts; whole packs
}

template <class Real>
void NodeGrid<Real>::reach(int row) {
  const int rows = row + 3 + spare_rows;
  if (rows > nodes_.rows) resize(rows + rows / 16);
}

template <class Real>
void NodeGrid<Real>::resize(int rows) {
  nodes_.rows = rows;
  const std::ptrdiff_t nodes = static_cast<std::ptrdiff_t>(nodes_.rows) * nodes_.stride;
  // one more group before the first and behind the last: packs look at their neighbours
  const auto grow = [&](AlignedArray<Real>& values, int components) {
    constexpr int width = Nodes<Real>::width;
    AlignedArray<Real> more(static_cast<std::size_t>((nodes + 2 * width) * components));
    std::copy_n(values.data(), values.size(), more.data());
    values = std::move(more);
    return values.data() + width * components;
  };
  nodes_.motion = grow(motion_, motion_components);
  nodes_.sums = grow(sums_, 3 * sum_components);
}

/// A node on a mirror: it and its image are one, of twice the mass, momentum and force.
template <class Real>
void NodeGrid<Real>::stop(int i, int j, int axis) {
  for (const Motion c : {motion_mass, motion_x, motion_y, change_x, change_y}) at(c, i, j) *= 2;
  at(axis == 0 ? motion_x : motion_y, i, j) = 0;
  at(axis == 0 ? change_x : change_y, i, j) = 0;
}

/// Adds to each of two nodes the image of the other.
template <class Real>
void NodeGrid<Real>::join(int i, int j, int image_i, int image_j, int axis) {
  for (const Motion c : {motion_mass, motion_x, motion_y, change_x, change_y}) {
    const bool normal = c == (axis == 0 ? motion_x : motion_y) || c == (axis == 0 ? change_x : change_y);
    const Real sign = normal ? -1 : 1;
    Real &a = at(c, i, j), &b = at(c, image_i, image_j);
    a += sign * b;
    b = sign * a;
  }
}

template <class Real>
void NodeGrid<Real>::reflect_sides(int first_row, int last_row) {
  const int right = nodes_.columns;
  for (int j = first_row; j <= last_row; ++j) {
    stop(0, j, 0);
    join(1, j, -1, j, 0);
    stop(right, j, 0);
    join(right - 1, j, right + 1, j, 0);
  }
}

template <class Real>
void NodeGrid<Real>::reflect_floor() {
  for (int i = -1; i <= nodes_.columns + 1; ++i) {
    stop(i, 0, 1);
    join(i, 1, i, -1, 1);
  }
}

template <class Real>
void NodeGrid<Real>::move_to(int i, int j, Real velocity_x, Real velocity_y) {
  Real &vx = at(motion_x, i, j), &vy = at(motion_y, i, j);
  Real &dx = at(Motion::change_x, i, j), &dy = at(Motion::change_y, i, j);
  const Real more_x = velocity_x - vx, more_y = velocity_y - vy;
  vx = velocity_x, vy = velocity_y;
  dx += more_x, dy += more_y;
  const Real half = 0.5;
  const Real heat = -(more_x * (vx - half * dx) + more_y * (vy - half * dy));
  at(change_square, i, j) = dx * dx + dy * dy + 2 * heat;
}

template <class Real>
void NodeGrid<Real>::push_off_wall() {
  for (int i = -1; i <= nodes_.columns + 1; ++i) {
    const Real wall_mass = at(motion_mass, i, 0);
    if (wall_mass == 0) continue;
    const Real below_mass = at(motion_mass, i, -1), above_mass = at(motion_mass, i, 1);
    const Real below_y = at(motion_y, i, -1), wall_y = at(motion_y, i, 0), above_y = at(motion_y, i, 1);
    // The velocity of the common momentum of the node above and the image of the one below.
    const Real both = above_mass + below_mass;
    Real x = at(motion_x, i, 1), y = above_y;
    if (below_mass > 0) {
      x = (above_mass * x + below_mass * at(motion_x, i, -1)) / both;
      y = (above_mass * y - below_mass * below_y) / both;
    }
    const Real push = above_mass * (y - above_y) - wall_mass * wall_y + below_mass * (-y - below_y);
    if (!(push > 0)) continue;
    move_to(i, 0, at(motion_x, i, 0), 0);
    move_to(i, 1, x, y);
    move_to(i, -1, x, -y);
  }
}

template <class Real>
void NodeGrid<Real>::copy_rows(Grid& grid, double rho0, int first, int last, int first_used,
                               int last_used) const {
  grid.grow_to_row(last);
  const double unit = rho0 * grid.cell().x() * grid.cell().y();
  for (int j = std::max(first, -1); j <= last; ++j)
    for (int i = -1; i <= nodes_.columns + 1; ++i) {
      Node& to = grid.at(i, j);
      to = Node{};
      if (j < first_used || j > last_used) continue;
      const auto value = [&](Motion component) {
        return static_cast<double>(nodes_.motion[Nodes<Real>::motion_at(number(i, j), component)]);
      };
      to.mass = value(motion_mass) * unit;
      to.velocity = Vec2(value(motion_x), value(motion_y));
    }
}

template <class Real>
std::size_t NodeGrid<Real>::memory() const {
  return (motion_.size() + sums_.size()) * sizeof(Real);
}

template <class Real>
void NodeGrid<Real>::carry(Archive& a) {
  int rows = nodes_.rows;
  a.integer("rows", rows);
  if (rows > nodes_.rows) resize(rows);
  mpm::fast::carry(motion_, motion_.size(), "motion", a), mpm::fast::carry(sums_, sums_.size(), "sums", a);
}

template class NodeGrid<double>;
template class NodeGrid<float>;

}  // namespace mpm::fast
