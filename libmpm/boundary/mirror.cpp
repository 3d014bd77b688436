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

}  // namespace mpm
