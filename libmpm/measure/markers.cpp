#include "libmpm/measure/markers.hpp"

#include <algorithm>

#include "libmpm/shape/bspline2.hpp"

namespace mpm {
namespace {

/// Share of the heaviest node's mass below which a node counts in proportion to its mass.
constexpr double light = 1e-4;

}  // namespace

template <int axes>
void move_markers(std::span<Vec<axes>> markers, const BasicGrid<axes>& grid, double dt) {
  using Vector = Vec<axes>;
  using Node = BasicNode<axes>;
  for (Vector& x : markers) {
    const auto n = stencil_at<BSpline2>(grid, x, Vector::Zero());
    if (n.y.first < -1 || n.y.first + 4 > grid.rows())
      continue;  // beyond every particle: nothing to move with
    double heaviest = 0;
    n.for_each(grid,
               [&](const Node& node, double, const Vector&) { heaviest = std::max(heaviest, node.mass); });
    if (heaviest == 0) continue;
    Vector velocity = Vector::Zero();
    double weight = 0;
    n.for_each(grid, [&](const Node& node, double share, const Vector&) {
      const double w = share * std::min(1.0, node.mass / (light * heaviest));
      weight += w;
      velocity += w * node.velocity;
    });
    if (weight > 0) x += (dt / weight) * velocity;
  }
}

template <int axes>
RowRange rows_of(std::span<const Vec<axes>> markers, const BasicGrid<axes>& grid) {
  using Vector = Vec<axes>;
  const auto [low, high] = std::minmax_element(
      markers.begin(), markers.end(), [](const Vector& a, const Vector& b) { return a.y() < b.y(); });
  const auto row = [&](const Vector& x) {
    return nearest_node((x.y() - grid.origin().y()) * grid.inverse_cell().y());
  };
  return {row(*low) - 1, row(*high) + 1};
}

template void move_markers(std::span<Vec2>, const Grid&, double);
template void move_markers(std::span<Vec3>, const BasicGrid<3>&, double);
template RowRange rows_of(std::span<const Vec2>, const Grid&);
template RowRange rows_of(std::span<const Vec3>, const BasicGrid<3>&);

}  // namespace mpm
