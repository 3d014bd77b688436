#include "libmpm/boundary/mirror.hpp"

#include "libmpm/boundary/grid_nodes.hpp"

namespace mpm {

void reflect_sides(Grid& grid, int top_row) {
  walls::reflect_sides(GridNodes{grid}, grid.columns(), -Grid::ghosts, top_row, Grid::ghosts);
}

void reflect_row(Grid& grid, int row, int layers) {
  walls::reflect_row(GridNodes{grid}, row, -Grid::ghosts, grid.columns() + Grid::ghosts, layers);
}

void reflect_sides(BasicGrid<3>& grid, int top_row) {
  constexpr int ghosts = BasicGrid<3>::ghosts;
  each_slice(
      grid, [&](SliceNodes nodes) { walls::reflect_sides(nodes, grid.columns(), -ghosts, top_row, ghosts); });
  for (int i = -ghosts; i <= grid.columns() + ghosts; ++i)
    walls::reflect_sides(DepthNodes{grid, i}, grid.slices(), -ghosts, top_row, ghosts, 2);
}

void reflect_row(BasicGrid<3>& grid, int row, int layers) {
  constexpr int ghosts = BasicGrid<3>::ghosts;
  each_slice(grid, [&](SliceNodes nodes) {
    walls::reflect_row(nodes, row, -ghosts, grid.columns() + ghosts, layers);
  });
}

bool at_open_face(const Grid& grid, const OpenSides& open, Floor floor, int top_row) {
  for (int j = 0; j <= top_row; ++j)
    if ((open.left && grid.at(0, j).mass > 0) || (open.right && grid.at(grid.columns(), j).mass > 0))
      return true;
  if (floor == Floor::open)
    for (int i = 0; i <= grid.columns(); ++i)
      if (grid.at(i, 0).mass > 0) return true;
  return false;
}

bool at_open_face(const BasicGrid<3>& grid, const OpenSides& open, Floor floor, int top_row) {
  const int right = grid.columns(), back = grid.slices();
  for (int j = 0; j <= top_row; ++j) {
    for (int k = 0; k <= back; ++k)
      if ((open.left && grid.at(0, j, k).mass > 0) || (open.right && grid.at(right, j, k).mass > 0))
        return true;
    for (int i = 0; i <= right; ++i)
      if ((open.front && grid.at(i, j, 0).mass > 0) || (open.back && grid.at(i, j, back).mass > 0))
        return true;
  }
  if (floor == Floor::open)
    for (int k = 0; k <= back; ++k)
      for (int i = 0; i <= right; ++i)
        if (grid.at(i, 0, k).mass > 0) return true;
  return false;
}

}  // namespace mpm
