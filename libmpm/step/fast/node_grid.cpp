#include "libmpm/step/fast/node_grid.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/boundary/walls.hpp"

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

/// The nodes, for walls.hpp: one layer behind the walls, and the change of velocity in place of its rate.
template <class Real>
struct NodeGrid<Real>::WallNodes {
  NodeGrid& grid;

  walls::WallNode<Real> at(int i, int j) const {
    return {grid.at(motion_mass, i, j),
            {&grid.at(motion_x, i, j), &grid.at(motion_y, i, j)},
            {&grid.at(change_x, i, j), &grid.at(change_y, i, j)}};
  }
  /// Particles take it up together with the heat of the transfer.
  void leave_heat(int i, int j, Real heat) const {
    const Real dx = grid.at(change_x, i, j), dy = grid.at(change_y, i, j);
    grid.at(change_square, i, j) = dx * dx + dy * dy + 2 * heat;
  }
};

template <class Real>
void NodeGrid<Real>::reflect_sides(int first_row, int last_row) {
  walls::reflect_sides(WallNodes{*this}, nodes_.columns, first_row, last_row, 1);
}

template <class Real>
bool NodeGrid<Real>::at_open_face(const OpenSides& open, Floor floor, int first_row, int last_row) {
  const auto has_mass = [&](int i, int j) { return at(motion_mass, i, j) > 0; };
  return walls::at_sides(has_mass, open.left, open.right, nodes_.columns, std::max(first_row, 0), last_row) ||
         (floor == Floor::open && first_row <= 0 && walls::at_floor(has_mass, nodes_.columns));
}

template <class Real>
void NodeGrid<Real>::reflect_floor() {
  walls::reflect_row(WallNodes{*this}, 0, -1, nodes_.columns + 1, 1);
}

template <class Real>
void NodeGrid<Real>::push_off_wall() {
  walls::push_off_wall(WallNodes{*this}, -1, nodes_.columns + 1, 1, Real(1));
}

template <class Real>
void NodeGrid<Real>::copy_rows(Grid& grid, double unit, int first, int last, int first_used,
                               int last_used) const {
  grid.grow_to_row(last);
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
