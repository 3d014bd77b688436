#pragma once
#include "libmpm/boundary/walls.hpp"
#include "libmpm/core/grid.hpp"

namespace mpm {

template <int axes>
walls::WallNode<double, axes> wall_node(double& mass, Vec<axes>& v, Vec<axes>& a) {
  walls::WallNode<double, axes> node{mass, {}, {}};
  for (int k = 0; k < axes; ++k)
    node.v[static_cast<std::size_t>(k)] = &v[k], node.a[static_cast<std::size_t>(k)] = &a[k];
  return node;
}
template <int axes>
walls::WallNode<double, axes> wall_node(BasicNode<axes>& n) {
  return wall_node<axes>(n.mass, n.velocity, n.acceleration);
}

/// The nodes of a Grid, for walls.hpp.
struct GridNodes {
  Grid& grid;

  auto at(int i, int j) const { return wall_node(grid.at(i, j)); }
  void leave_heat(int i, int j, double heat) const { grid.at(i, j).contact_heat = heat; }
};

/// Those of one slice: columns go along x.
struct SliceNodes {
  BasicGrid<3>& grid;
  int slice;

  auto at(int i, int j) const { return wall_node(grid.at(i, j, slice)); }
  void leave_heat(int i, int j, double heat) const { grid.at(i, j, slice).contact_heat = heat; }
};

/// Those of one column of every slice: columns go along z.
struct DepthNodes {
  BasicGrid<3>& grid;
  int column;

  auto at(int k, int j) const { return wall_node(grid.at(column, j, k)); }
};

/// Calls use(nodes) for every slice, the ghosts too.
template <class Use>
void each_slice(BasicGrid<3>& grid, Use use) {
  for (int k = -grid.ghosts; k <= grid.slices() + grid.ghosts; ++k) use(SliceNodes{grid, k});
}

}  // namespace mpm
