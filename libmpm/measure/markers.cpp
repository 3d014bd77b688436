#include "libmpm/measure/markers.hpp"

#include "libmpm/shape/bspline2.hpp"

namespace mpm {

void move_markers(std::span<Vec2> markers, const Grid& grid, double dt) {
  for (Vec2& x : markers) {
    const Stencil n = stencil_at<BSpline2>(grid, x, Vec2::Zero());
    if (n.y.first < -1 || n.y.first + 4 > grid.rows())
      continue;  // beyond every particle: nothing to move with
    Vec2 velocity = Vec2::Zero();
    double weight = 0;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const Node& node = grid.at(n.x.first + i, n.y.first + j);
        if (node.mass == 0) continue;
        weight += n.weight(i, j);
        velocity += n.weight(i, j) * node.velocity;
      }
    if (weight > 0) x += (dt / weight) * velocity;
  }
}

}  // namespace mpm
