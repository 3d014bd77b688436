#include "libmpm/verification/lagrangian/quad_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace mpm::verification::lagrangian {
namespace {

using std::numbers::pi;

/// Of a polygon with a corner every `turn` around the circle, whose area is that of the circle.
double corner_radius(double radius, double turn) { return radius * std::sqrt(turn / std::sin(turn)); }

/// The point of the circle at this angle; on the axes to the last bit.
Vec2 on_circle(double radius, int step, int steps_per_quarter) {
  if (step % steps_per_quarter == 0) {
    const int quarter = step / steps_per_quarter;  // -1, 0, 1 from below upwards
    return quarter == 0 ? Vec2(radius, 0) : Vec2(0, quarter * radius);
  }
  const double angle = step * (pi / 2) / steps_per_quarter;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

int QuadMesh::add_node(Vec2 x, std::uint8_t hold) {
  nodes.push_back(x);
  holds.push_back(hold);
  return static_cast<int>(nodes.size()) - 1;
}

QuadMesh block_mesh(double width, double height, int columns, int rows) {
  QuadMesh m;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      m.add_node({width * i / columns, height * j / rows},
                 static_cast<std::uint8_t>((i == 0 || i == columns ? held_x : 0) + (j == 0 ? on_floor : 0)));
  m.add_block(columns, rows, [&](int i, int j) { return j * (columns + 1) + i; });
  return m;
}

QuadMesh ring_mesh(double inner_radius, double outer_radius, int around, int layers) {
  QuadMesh m;
  const double turn = pi / 2 / around;
  for (int j = 0; j <= around; ++j)
    for (int i = 0; i <= layers; ++i) {
      const double r = inner_radius + (outer_radius - inner_radius) * i / layers;
      const int node = m.add_node(on_circle(corner_radius(r, turn), j, around),
                                  static_cast<std::uint8_t>(j == 0        ? held_y
                                                            : j == around ? held_x
                                                                          : 0));
      if (i == 0) m.rim.push_back(node);
    }
  m.add_block(layers, around, [&](int i, int j) { return j * (layers + 1) + i; });
  return m;
}

QuadMesh cavity_mesh(const CavityBlock& b, int cells, int times) {
  const double r = b.radius, h = r / cells;
  if (!(b.center_height > r && b.center_height + r < b.height && r < b.width))
    throw std::invalid_argument("cavity_mesh: the cavity must lie inside of the block");
  // the rectangle around the rings: one and a half radii each way, or to the side of the block
  const auto reach = [&](double to_side) { return to_side < 1.9 * r ? to_side : 1.5 * r; };
  const double below = reach(b.center_height), above = reach(b.height - b.center_height),
               right = reach(b.width);
  const auto count = [&](double length, double size) {
    return length <= 0 ? 0 : times * std::max(1, static_cast<int>(std::lround(length / size)));
  };
  const int eighth = count(pi / 4 * r, h);
  const int rings = count((below + above + right) / 3 - r, h);
  const double column = right / eighth * times, row = (below + above) / (2 * eighth) * times;
  const int beside = count(b.width - right, column), under = count(b.center_height - below, row),
            over = count(b.height - b.center_height - above, row);

  // the lattice of the rectangles; what lies inside of the rings' rectangle has no node
  const int columns = eighth + beside, rows = under + 2 * eighth + over;
  const double low = b.center_height - below, high = b.center_height + above;
  const auto x_of = [&](int i) {
    return i <= eighth ? right * i / eighth : right + (b.width - right) * (i - eighth) / beside;
  };
  const auto y_of = [&](int j) {
    if (j < under) return low * j / under;
    if (j <= under + 2 * eighth) return low + (high - low) * (j - under) / (2 * eighth);
    return high + (b.height - high) * (j - under - 2 * eighth) / over;
  };
  QuadMesh m;
  std::vector<int> lattice(static_cast<std::size_t>((columns + 1) * (rows + 1)), -1);
  const auto at = [&](int i, int j) -> int& {
    return lattice[static_cast<std::size_t>(j * (columns + 1) + i)];
  };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      if (i < eighth && j > under && j < under + 2 * eighth) continue;
      const int hold = (i == 0 || i == columns ? held_x : 0) + (j == 0 ? on_floor : 0);
      at(i, j) = m.add_node({i == columns ? b.width : x_of(i), j == rows ? b.height : y_of(j)},
                            static_cast<std::uint8_t>(hold));
    }
  m.add_block(beside, 2 * eighth, [&](int i, int j) { return at(eighth + i, under + j); });
  m.add_block(columns, under, [&](int i, int j) { return at(i, j); });
  m.add_block(columns, over, [&](int i, int j) { return at(i, under + 2 * eighth + j); });

  // rings from the rim outwards, each from below upwards; the last one is the side of the rectangle
  const int around = 4 * eighth;
  const auto side = [&](int k) {
    if (k <= eighth) return at(k, under);
    if (k <= 3 * eighth) return at(eighth, under + k - eighth);
    return at(around - k, under + 2 * eighth);
  };
  const double corner = corner_radius(r, pi / around);
  std::vector<int> ring(static_cast<std::size_t>((rings + 1) * (around + 1)));
  const auto ringed = [&](int i, int k) -> int& {
    return ring[static_cast<std::size_t>(k * (rings + 1) + i)];
  };
  for (int k = 0; k <= around; ++k) {
    const Vec2 inner = Vec2(0, b.center_height) + on_circle(corner, k - 2 * eighth, 2 * eighth);
    const int outer = side(k);
    for (int i = 0; i < rings; ++i) {
      const double share = static_cast<double>(i) / rings;
      ringed(i, k) = m.add_node(inner + share * (m.nodes[static_cast<std::size_t>(outer)] - inner),
                                static_cast<std::uint8_t>(k == 0 || k == around ? held_x : 0));
    }
    ringed(rings, k) = outer;
    m.rim.push_back(ringed(0, k));
  }
  m.add_block(rings, around, [&](int i, int k) { return ringed(i, k); });
  return m;
}

}  // namespace mpm::verification::lagrangian
