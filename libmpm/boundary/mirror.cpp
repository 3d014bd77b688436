#include "libmpm/boundary/mirror.hpp"

namespace mpm {
namespace {

Vec2 image(const Vec2& v) { return {-v.x(), v.y()}; }

/// Adds to each of two nodes the image of the other.
void join(Node& a, Node& b) {
  a.mass += b.mass;
  a.velocity += image(b.velocity);
  a.acceleration += image(b.acceleration);
  b.mass = a.mass;
  b.velocity = image(a.velocity);
  b.acceleration = image(a.acceleration);
}

/// A node on the mirror: it and its image are one. Its doubled mass, momentum and force keep their ratios.
void stop(Node& n) {
  n.velocity.x() = 0;
  n.acceleration.x() = 0;
}

}  // namespace

void reflect_sides(Grid& grid, int top_row) {
  const int right = grid.columns();
  for (int j = -1; j <= top_row; ++j) {
    stop(grid.at(0, j));
    join(grid.at(1, j), grid.at(-1, j));
    stop(grid.at(right, j));
    join(grid.at(right - 1, j), grid.at(right + 1, j));
  }
}

}  // namespace mpm
