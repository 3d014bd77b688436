#include "libmpm/boundary/mirror.hpp"

namespace mpm {
namespace {

/// Adds to each of two nodes the image of the other. Axis: 0 for a mirror across x, 1 across y.
void join(Node& a, Node& b, int axis) {
  const auto image = [axis](Vec2 v) {
    v[axis] = -v[axis];
    return v;
  };
  a.mass += b.mass;
  a.velocity += image(b.velocity);
  a.acceleration += image(b.acceleration);
  b.mass = a.mass;
  b.velocity = image(a.velocity);
  b.acceleration = image(a.acceleration);
}

/// A node on the mirror: it and its image are one, of twice the mass, momentum and force.
void stop(Node& n, int axis) {
  n.mass *= 2;
  n.velocity *= 2;
  n.acceleration *= 2;
  n.velocity[axis] = 0;
  n.acceleration[axis] = 0;
}

}  // namespace

void reflect_sides(Grid& grid, int top_row) {
  const int right = grid.columns();
  for (int j = -Grid::ghosts; j <= top_row; ++j) {
    stop(grid.at(0, j), 0);
    stop(grid.at(right, j), 0);
    for (int k = 1; k <= Grid::ghosts; ++k) {
      join(grid.at(k, j), grid.at(-k, j), 0);
      join(grid.at(right - k, j), grid.at(right + k, j), 0);
    }
  }
}

void reflect_row(Grid& grid, int row, int layers) {
  for (int i = -Grid::ghosts; i <= grid.columns() + Grid::ghosts; ++i) {
    stop(grid.at(i, row), 1);
    for (int k = 1; k <= layers; ++k) join(grid.at(i, row + k), grid.at(i, row - k), 1);
  }
}

}  // namespace mpm
