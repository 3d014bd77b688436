#include "libmpm/boundary/impact_wall.hpp"

namespace mpm {
namespace {

void move_to(Node& n, const Vec2& velocity, double dt) {
  const Vec2 change = velocity - n.velocity;
  n.velocity = velocity;
  n.acceleration += change / dt;
  n.contact_heat = -change.dot(n.velocity - 0.5 * dt * n.acceleration);
}

}  // namespace

void apply_impact_wall(Grid& grid, double dt) {
  for (int i = -1; i <= grid.columns() + 1; ++i) {
    Node &below = grid.at(i, -1), &wall = grid.at(i, 0), &above = grid.at(i, 1);
    if (wall.mass == 0) continue;
    // The velocity of the common momentum of the node above and the image of the one below.
    const double both = above.mass + below.mass;
    Vec2 velocity = above.velocity;
    if (below.mass > 0)
      velocity =
          (above.mass * above.velocity + below.mass * Vec2(below.velocity.x(), -below.velocity.y())) / both;
    const double push = above.mass * (velocity.y() - above.velocity.y()) - wall.mass * wall.velocity.y() +
                        below.mass * (-velocity.y() - below.velocity.y());
    if (!(push > 0)) continue;
    move_to(wall, Vec2(wall.velocity.x(), 0), dt);
    move_to(above, velocity, dt);
    move_to(below, Vec2(velocity.x(), -velocity.y()), dt);
  }
}

}  // namespace mpm
