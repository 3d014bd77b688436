#include "libmpm/step/fast/node_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "libmpm/core/errors.hpp"

namespace mpm::fast {
namespace {
constexpr int spare_rows = 4;  ///< that a step may climb; more than a cell is a breakdown anyway
}  // namespace

template <class Real, int axes>
NodeGrid<Real, axes>::NodeGrid(const Grid& grid) {
  constexpr int width = Nodes::width;
  nodes_.columns = grid.columns();
  nodes_.stride = (nodes_.columns + 3 + width - 1) / width * width;  // with two ghosts; whole packs
  if constexpr (axes == 3) nodes_.slices = grid.slices();
  nodes_.to_row = axes == 3 ? nodes_.stride * (nodes_.slices + 3) : nodes_.stride;
}

template <class Real, int axes>
void NodeGrid<Real, axes>::reach(int row) {
  const int rows = row + 3 + spare_rows;
  if (rows > nodes_.rows) resize(rows + rows / 16);
}

template <class Real, int axes>
void NodeGrid<Real, axes>::resize(int rows) {
  const std::ptrdiff_t nodes = static_cast<std::ptrdiff_t>(rows) * nodes_.to_row;
  if (nodes * M::components > INT32_MAX)
    throw InputError("the grid has " + std::to_string(nodes) + " nodes: the fast step counts at most " +
                     std::to_string(INT32_MAX / M::components) +
                     "; take larger cells or kernel = \"reference\"");
  nodes_.rows = rows;
  // one more group before the first and behind the last: packs look at their neighbours
  const auto grow = [&](AlignedArray<Real>& values, int components) {
    constexpr int width = Nodes::width;
    AlignedArray<Real> more(static_cast<std::size_t>((nodes + 2 * width) * components));
    std::copy_n(values.data(), values.size(), more.data());
    values = std::move(more);
    return values.data() + width * components;
  };
  nodes_.motion = grow(motion_, M::components);
  nodes_.sums = grow(sums_, Nodes::entries);
}

/// The nodes of a slice, for walls.hpp: one layer behind the walls, and the change of velocity in place of
/// its rate.
template <class Real, int axes>
struct NodeGrid<Real, axes>::Slice {
  NodeGrid& grid;
  int slice;

  auto at(int i, int j) const { return grid.wall_node(i, j, slice); }
  /// Particles take it up together with the heat of the transfer.
  void leave_heat(int i, int j, Real heat) const {
    Real square = 0;
    for (int a = 0; a < axes; ++a) {
      const Real change = grid.at(M::change + a, i, j, slice);
      square = a == 0 ? change * change : square + change * change;
    }
    grid.at(M::change_square, i, j, slice) = square + 2 * heat;
  }
};

/// Those of one column of every slice: columns go along z.
template <class Real, int axes>
struct NodeGrid<Real, axes>::Column {
  NodeGrid& grid;
  int column;

  auto at(int k, int j) const { return grid.wall_node(column, j, k); }
};

template <class Real, int axes>
walls::WallNode<Real, axes> NodeGrid<Real, axes>::wall_node(int i, int j, int k) {
  walls::WallNode<Real, axes> node{at(M::mass, i, j, k), {}, {}};
  for (int a = 0; a < axes; ++a) {
    node.v[static_cast<std::size_t>(a)] = &at(M::velocity + a, i, j, k);
    node.a[static_cast<std::size_t>(a)] = &at(M::change + a, i, j, k);
  }
  return node;
}

template <class Real, int axes>
template <class Use>
void NodeGrid<Real, axes>::each_slice(Use use) {
  if constexpr (axes == 2) {
    use(Slice{*this, -1});
  } else {
    for (int k = -1; k <= nodes_.slices + 1; ++k) use(Slice{*this, k});
  }
}

template <class Real, int axes>
void NodeGrid<Real, axes>::reflect_sides(int first_row, int last_row) {
  each_slice([&](Slice s) { walls::reflect_sides(s, nodes_.columns, first_row, last_row, 1); });
  if constexpr (axes == 3)
    for (int i = -1; i <= nodes_.columns + 1; ++i)
      walls::reflect_sides(Column{*this, i}, nodes_.slices, first_row, last_row, 1, 2);
}

template <class Real, int axes>
bool NodeGrid<Real, axes>::at_open_face(const OpenSides& open, Floor floor, int first_row, int last_row) {
  const auto has_mass = [&](int i, int j, int k) { return at(M::mass, i, j, axes == 3 ? k : -1) > 0; };
  return walls::at_open_face(has_mass, open, floor == Floor::open && first_row <= 0, nodes_.columns,
                             nodes_.slices, std::max(first_row, 0), last_row);
}

template <class Real, int axes>
void NodeGrid<Real, axes>::reflect_floor() {
  each_slice([&](Slice s) { walls::reflect_row(s, 0, -1, nodes_.columns + 1, 1); });
}

template <class Real, int axes>
void NodeGrid<Real, axes>::push_off_wall(std::vector<double>* gaps, double dt) {
  const int slices = axes == 3 ? nodes_.slices + 3 : 1;
  each_slice([&](Slice s) {
    walls::push_off_wall(s, -1, nodes_.columns + 1, 1, Real(1),
                         walls::gaps_of_slice(gaps, nodes_.columns + 3, slices, s.slice + 1, dt));
  });
}

template <class Real, int axes>
void NodeGrid<Real, axes>::copy_rows(Grid& grid, double unit, int first, int last, int first_used,
                                     int last_used) const {
  grid.grow_to_row(last);
  const auto copy = [&](BasicNode<axes>& to, int i, int j, int k) {
    to = BasicNode<axes>{};
    if (j < first_used || j > last_used) return;
    const auto value = [&](int component) {
      return static_cast<double>(nodes_.motion[Nodes::motion_at(number(i, j, k), component)]);
    };
    to.mass = value(M::mass) * unit;
    for (int a = 0; a < axes; ++a) to.velocity[a] = value(M::velocity + a);
  };
  for (int j = std::max(first, -1); j <= last; ++j)
    for (int i = -1; i <= nodes_.columns + 1; ++i)
      if constexpr (axes == 3)
        for (int k = -1; k <= nodes_.slices + 1; ++k) copy(grid.at(i, j, k), i, j, k);
      else
        copy(grid.at(i, j), i, j, -1);
}

template <class Real, int axes>
std::size_t NodeGrid<Real, axes>::memory() const {
  return (motion_.size() + sums_.size()) * sizeof(Real);
}

template <class Real, int axes>
void NodeGrid<Real, axes>::carry(Archive& a) {
  int rows = nodes_.rows;
  a.integer("rows", rows);
  if (rows > nodes_.rows) resize(rows);
  mpm::fast::carry(motion_, motion_.size(), "motion", a), mpm::fast::carry(sums_, sums_.size(), "sums", a);
}

template class NodeGrid<double, 2>;
template class NodeGrid<float, 2>;
template class NodeGrid<double, 3>;
template class NodeGrid<float, 3>;

}  // namespace mpm::fast
