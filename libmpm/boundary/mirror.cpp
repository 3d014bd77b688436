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
  return walls::at_open_face([&](int i, int j, int) { return grid.at(i, j).mass > 0; }, open,
                             floor == Floor::open, grid.columns(), 0, 0, top_row);
}

bool at_open_face(const BasicGrid<3>& grid, const OpenSides& open, Floor floor, int top_row) {
  return walls::at_open_face([&](int i, int j, int k) { return grid.at(i, j, k).mass > 0; }, open,
                             floor == Floor::open, grid.columns(), grid.slices(), 0, top_row);
}

}  // namespace mpm
