#include "libmpm/boundary/impact_wall.hpp"

#include "libmpm/boundary/grid_nodes.hpp"

namespace mpm {

void apply_impact_wall(Grid& grid, double dt, std::vector<double>* gaps) {
  constexpr int ghosts = Grid::ghosts;
  const int columns = grid.columns() + 2 * ghosts + 1;
  walls::push_off_wall(GridNodes{grid}, -ghosts, grid.columns() + ghosts, ghosts, dt,
                       walls::gaps_of_slice(gaps, columns, 1, 0, dt));
}

void apply_impact_wall(BasicGrid<3>& grid, double dt, std::vector<double>* gaps) {
  constexpr int ghosts = BasicGrid<3>::ghosts;
  const int columns = grid.columns() + 2 * ghosts + 1, slices = grid.slices() + 2 * ghosts + 1;
  each_slice(grid, [&](SliceNodes nodes) {
    walls::push_off_wall(nodes, -ghosts, grid.columns() + ghosts, ghosts, dt,
                         walls::gaps_of_slice(gaps, columns, slices, nodes.slice + ghosts, dt));
  });
}

}  // namespace mpm
