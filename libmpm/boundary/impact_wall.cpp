#include "libmpm/boundary/impact_wall.hpp"

#include "libmpm/boundary/grid_nodes.hpp"

namespace mpm {

void apply_impact_wall(Grid& grid, double dt) {
  walls::push_off_wall(GridNodes{grid}, -Grid::ghosts, grid.columns() + Grid::ghosts, Grid::ghosts, dt);
}

void apply_impact_wall(BasicGrid<3>& grid, double dt) {
  constexpr int ghosts = BasicGrid<3>::ghosts;
  each_slice(grid, [&](SliceNodes nodes) {
    walls::push_off_wall(nodes, -ghosts, grid.columns() + ghosts, ghosts, dt);
  });
}

}  // namespace mpm
