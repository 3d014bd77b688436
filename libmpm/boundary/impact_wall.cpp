#include "libmpm/boundary/impact_wall.hpp"

namespace mpm {
namespace {

void move_to(Node& n, const Vec2& velocity, double dt) {
  const Vec2 change = velocity - n.velocity;
  n.velocity = velocity;
  n.acceleration += change / dt;
  n.contact_heat = -change.dot(n.velocity - 0.5 * dt * n.acceleration);
}

/// The velocity of the common momentum of a node above the wall and the image of the one below.
Vec2 common_velocity(const Node& above, const Node& below) {
  if (!(below.mass > 0)) return above.velocity;
  const Vec2 image(below.velocity.x(), -below.velocity.y());
  return (above.mass * above.velocity + below.mass * image) / (above.mass + below.mass);
}

}  // namespace

void apply_impact_wall(Grid& grid, double dt) {
  for (int i = -Grid::ghosts; i <= grid.columns() + Grid::ghosts; ++i) {
    Node& wall = grid.at(i, 0);
    if (wall.mass == 0) continue;
    double push = -wall.mass * wall.velocity.y();
    for (int k = 1; k <= Grid::ghosts; ++k) {
      const Node &above = grid.at(i, k), &below = grid.at(i, -k);
      const double y = common_velocity(above, below).y();
      push = above.mass * (y - above.velocity.y()) + push + below.mass * (-y - below.velocity.y());
    }
    if (!(push > 0)) continue;
    move_to(wall, Vec2(wall.velocity.x(), 0), dt);
    for (int k = 1; k <= Grid::ghosts; ++k) {
      Node &above = grid.at(i, k), &below = grid.at(i, -k);
      if (above.mass == 0 && below.mass == 0) continue;
      const Vec2 velocity = common_velocity(above, below);
      move_to(above, velocity, dt);
      move_to(below, Vec2(velocity.x(), -velocity.y()), dt);
    }
  }
}

}  // namespace mpm
