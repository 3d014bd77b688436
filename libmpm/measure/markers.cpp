#include "libmpm/measure/markers.hpp"

#include <algorithm>

#include "libmpm/shape/bspline2.hpp"

namespace mpm {
namespace {

/// Share of the heaviest node's mass below which a node counts in proportion to its mass.
constexpr double light = 1e-4;

}  // namespace

void move_markers(std::span<Vec2> markers, const Grid& grid, double dt) {
  for (Vec2& x : markers) {
    const Stencil n = stencil_at<BSpline2>(grid, x, Vec2::Zero());
    if (n.y.first < -1 || n.y.first + 4 > grid.rows())
      continue;  // beyond every particle: nothing to move with
    double heaviest = 0;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) heaviest = std::max(heaviest, grid.at(n.x.first + i, n.y.first + j).mass);
    if (heaviest == 0) continue;
    Vec2 velocity = Vec2::Zero();
    double weight = 0;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const Node& node = grid.at(n.x.first + i, n.y.first + j);
        const double w = n.weight(i, j) * std::min(1.0, node.mass / (light * heaviest));
        weight += w;
        velocity += w * node.velocity;
      }
    if (weight > 0) x += (dt / weight) * velocity;
  }
}

RowRange rows_of(std::span<const Vec2> markers, const Grid& grid) {
  const auto [low, high] = std::minmax_element(markers.begin(), markers.end(),
                                               [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  const auto row = [&](const Vec2& x) {
    return nearest_node((x.y() - grid.origin().y()) * grid.inverse_cell().y());
  };
  return {row(*low) - 1, row(*high) + 1};
}

}  // namespace mpm
