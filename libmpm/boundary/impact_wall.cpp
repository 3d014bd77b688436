#include "libmpm/boundary/impact_wall.hpp"

#include "libmpm/boundary/grid_nodes.hpp"

namespace mpm {

void apply_impact_wall(Grid& grid, double dt) {
  walls::push_off_wall(GridNodes{grid}, -Grid::ghosts, grid.columns() + Grid::ghosts, Grid::ghosts, dt);
}

}  // namespace mpm
