#include "libmpm/boundary/mirror.hpp"

#include "libmpm/boundary/grid_nodes.hpp"

namespace mpm {

void reflect_sides(Grid& grid, int top_row) {
  walls::reflect_sides(GridNodes{grid}, grid.columns(), -Grid::ghosts, top_row, Grid::ghosts);
}

void reflect_row(Grid& grid, int row, int layers) {
  walls::reflect_row(GridNodes{grid}, row, -Grid::ghosts, grid.columns() + Grid::ghosts, layers);
}

}  // namespace mpm
