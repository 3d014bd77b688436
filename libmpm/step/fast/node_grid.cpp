#include "libmpm/step/fast/node_grid.hpp"

#include <algorithm>
#include <cmath>

namespace mpm::fast {
namespace {
constexpr int spare_rows = 3;  ///< that a step may climb; more than a cell is a breakdown anyway
}

template <class Real>
NodeGrid<Real>::NodeGrid(int columns) {
  nodes_.columns = columns;
  nodes_.stride = (columns + 5 + 3) / 4 * 4;  // two ghosts; the fourth lane of a stencil; whole quads
}

template <class Real>
void NodeGrid<Real>::prepare(double highest) {
  const int rows = static_cast<int>(highest) + 4 + spare_rows;
  if (rows > nodes_.rows) {
    nodes_.rows = rows + rows / 4;
    const std::size_t count =
        static_cast<std::size_t>(nodes_.rows) * static_cast<std::size_t>(nodes_.stride) + 8;
    motion_ = AlignedArray<Real>(4 * count);
    mass_ = AlignedArray<Real>(count);
    square_ = AlignedArray<Real>(count);
    nodes_.motion = motion_.data(), nodes_.mass = mass_.data(), nodes_.square = square_.data();
  } else if (first_ <= last_) {
    const std::size_t begin = index(-1, first_), size = index(-1, last_ + 1) - begin;
    std::fill_n(nodes_.motion + 4 * begin, 4 * size, Real{});
    std::fill_n(nodes_.mass + begin, size, Real{});
    std::fill_n(nodes_.square + begin, size, Real{});
  }
  first_ = 0, last_ = -1;
}

template <class Real>
void NodeGrid<Real>::use(double lowest, double highest) {
  first_ = -1, last_ = nodes_.rows - 2;  // where the heights make no sense, everything
  if (lowest > 3 && lowest < last_) first_ = static_cast<int>(lowest) - 1;
  if (highest >= 0 && highest + 2 < last_) last_ = static_cast<int>(highest) + 2;
}

/// A node on a mirror: it and its image are one, of twice the mass, momentum and force.
template <class Real>
void NodeGrid<Real>::stop(int i, int j, int axis) {
  Real* n = motion(i, j);
  for (int k = 0; k < 4; ++k) n[k] = k % 2 == axis ? Real(0) : 2 * n[k];
  nodes_.mass[index(i, j)] *= 2;
}

/// Adds to each of two nodes the image of the other.
template <class Real>
void NodeGrid<Real>::join(int i, int j, int image_i, int image_j, int axis) {
  Real *a = motion(i, j), *b = motion(image_i, image_j);
  for (int k = 0; k < 4; ++k) {
    const Real sign = k % 2 == axis ? -1 : 1;
    a[k] += sign * b[k];
    b[k] = sign * a[k];
  }
  Real &mass = nodes_.mass[index(i, j)], &image_mass = nodes_.mass[index(image_i, image_j)];
  mass += image_mass;
  image_mass = mass;
}

template <class Real>
void NodeGrid<Real>::reflect_sides() {
  const int right = nodes_.columns;
  for (int j = first_; j <= last_; ++j) {
    stop(0, j, 0);
    join(1, j, -1, j, 0);
    stop(right, j, 0);
    join(right - 1, j, right + 1, j, 0);
  }
}

template <class Real>
void NodeGrid<Real>::reflect_floor() {
  if (first_ > -1) return;
  for (int i = -1; i <= nodes_.columns + 1; ++i) {
    stop(i, 0, 1);
    join(i, 1, i, -1, 1);
  }
}

template <class Real>
void NodeGrid<Real>::move_to(int i, int j, Real velocity_x, Real velocity_y) {
  Real* n = motion(i, j);
  const Real change_x = velocity_x - n[0], change_y = velocity_y - n[1];
  n[0] = velocity_x, n[1] = velocity_y;
  n[2] += change_x, n[3] += change_y;
  const Real half = 0.5;
  const Real heat = -(change_x * (n[0] - half * n[2]) + change_y * (n[1] - half * n[3]));
  nodes_.square[index(i, j)] = n[2] * n[2] + n[3] * n[3] + 2 * heat;
}

template <class Real>
void NodeGrid<Real>::push_off_wall() {
  if (first_ > -1) return;
  for (int i = -1; i <= nodes_.columns + 1; ++i) {
    const Real wall_mass = nodes_.mass[index(i, 0)];
    if (wall_mass == 0) continue;
    const Real *below = motion(i, -1), *wall = motion(i, 0), *above = motion(i, 1);
    const Real below_mass = nodes_.mass[index(i, -1)], above_mass = nodes_.mass[index(i, 1)];
    // The velocity of the common momentum of the node above and the image of the one below.
    const Real both = above_mass + below_mass;
    Real x = above[0], y = above[1];
    if (below_mass > 0) {
      x = (above_mass * above[0] + below_mass * below[0]) / both;
      y = (above_mass * above[1] - below_mass * below[1]) / both;
    }
    const Real push = above_mass * (y - above[1]) - wall_mass * wall[1] + below_mass * (-y - below[1]);
    if (!(push > 0)) continue;
    move_to(i, 0, wall[0], 0);
    move_to(i, 1, x, y);
    move_to(i, -1, x, -y);
  }
}

template <class Real>
void NodeGrid<Real>::copy_rows(Grid& grid, double rho0, int first, int last) const {
  grid.grow_to_row(last);
  const double unit = rho0 * grid.cell().x() * grid.cell().y();
  for (int j = std::max(first, -1); j <= last; ++j)
    for (int i = -1; i <= nodes_.columns + 1; ++i) {
      Node& to = grid.at(i, j);
      to = Node{};
      if (j < first_ || j > last_) continue;
      const std::size_t n = index(i, j);
      to.mass = static_cast<double>(nodes_.mass[n]) * unit;
      to.velocity = Vec2(nodes_.motion[4 * n], nodes_.motion[4 * n + 1]);
    }
}

template <class Real>
std::size_t NodeGrid<Real>::memory() const {
  return (motion_.size() + mass_.size() + square_.size()) * sizeof(Real);
}

template class NodeGrid<double>;

}  // namespace mpm::fast
