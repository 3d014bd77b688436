#include "libmpm/measure/void_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/shape/bspline2.hpp"

namespace mpm {
namespace {

using std::numbers::pi;
constexpr double half_full = 0.5;
/// A region along the wall that is farther than this beside the first circle is the gap under a body that
/// leaves it. Two: the indicator smears an edge over that many.
constexpr int cells_beside_wall = 2;

/// Of a part of a unit square.
struct Part {
  double area = 0, moment_x = 0;
};

/// The part of a unit square where the bilinear corner values (a b / d c, counter-clockwise) are below 1/2,
/// by straight cuts. In a saddle the two empty corners are joined.
Part empty_part(const double (&corner)[4]) {
  double area2 = 0, moment6 = 0;
  Vec2 first, last;
  bool any = false;
  const Vec2 at[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto visit = [&](const Vec2& x) {
    if (any) {
      const double cross = last.x() * x.y() - x.x() * last.y();
      area2 += cross;
      moment6 += cross * (last.x() + x.x());
    } else
      first = x;
    any = true;
    last = x;
  };
  for (int k = 0; k < 4; ++k) {
    const double a = corner[k], b = corner[(k + 1) % 4];
    if (a < half_full) visit(at[k]);
    if ((a < half_full) != (b < half_full))
      visit(at[k] + ((half_full - a) / (b - a)) * (at[(k + 1) % 4] - at[k]));
  }
  if (any) visit(first);
  return {0.5 * area2, moment6 / 6};
}

/// The share of a tetrahedron where what is linear between its corners is below 1/2.
double empty_share(std::array<double, 4> corner) {
  std::ranges::sort(corner);
  const auto [a, b, c, d] = corner;
  const auto way = [](double from, double to) { return (half_full - from) / (to - from); };
  if (a >= half_full) return 0;
  if (b >= half_full) return way(a, b) * way(a, c) * way(a, d);
  if (c >= half_full) {  // the wedge of the edge ab as three tetrahedra
    const double ac = way(a, c), ad = way(a, d), bc = way(b, c), bd = way(b, d);
    return ac * ad + (1 - ac) * ad * bc + (1 - ad) * bc * bd;
  }
  if (d >= half_full) return 1 - (1 - way(a, d)) * (1 - way(b, d)) * (1 - way(c, d));
  return 1;
}

/// The same of a cube, whose corner number k is at (k & 1, k >> 1 & 1, k >> 2): six tetrahedra around the
/// diagonal from 0 to 7.
double empty_part(const std::array<double, 8>& corner) {
  constexpr int ways[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
  double sum = 0;
  for (const auto& [a, b] : ways)
    sum += empty_share(
        {corner[0], corner[static_cast<std::size_t>(a)], corner[static_cast<std::size_t>(b)], corner[7]});
  return sum / 6;
}

/// Calls use(node, weight) for the nodes that a point reaches.
template <class Use>
void each_weight(const ProductStencil<3, 2>& n, Use use) {
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) use(std::array{n.x.first + i, n.y.first + j}, n.weight(i, j));
}
template <class Use>
void each_weight(const ProductStencil<3, 3>& n, Use use) {
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i)
        use(std::array{n.x.first + i, n.z.first + k, n.y.first + j},
            n.x.value[i] * (n.y.value[j] * n.z.value[k]));
}

std::array<int, 2> last_nodes(const Grid& g, int rows) { return {g.columns(), rows}; }
std::array<int, 3> last_nodes(const BasicGrid<3>& g, int rows) { return {g.columns(), g.slices(), rows}; }

}  // namespace

template <int axes>
BasicIndicator<axes> indicator_of(const BasicState<axes>& s, int points_per_particle) {
  using Node = typename BasicIndicator<axes>::Node;
  const auto& g = s.grid;
  const auto& ps = s.particles;
  double highest = g.origin().y();
  for (const Vec<axes>& x : ps.position) highest = std::max(highest, x.y());
  const int rows = static_cast<int>((highest - g.origin().y()) * g.inverse_cell().y()) + 4;
  BasicIndicator<axes> field{last_nodes(g, rows), g.cell(), {}};

  // with a layer of ghosts around: node -1 is the first
  BasicIndicator<axes> raw = field;
  for (int& last : raw.last) last += 2;
  std::size_t count = 1;
  for (int axis = 0; axis < axes; ++axis) count *= static_cast<std::size_t>(raw.nodes(axis));
  raw.fraction.assign(count, 0.0);
  const auto at = [&](Node n) -> double& {
    for (int& k : n) ++k;
    return raw.fraction[raw.index(n)];
  };

  const double inverse = g.inverse_cell().prod();
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const double share = filled(s, p) * inverse / points_per_particle;
    for (int k = 0; k < points_per_particle; ++k) {
      Vec<axes> x = ps.position[p];
      if (points_per_particle > 1)
        for (int axis = 0; axis < axes; ++axis)
          x[axis] += 0.5 * ((k >> axis) % 2 ? 1 : -1) * ps.half_size[p][axis];
      each_weight(stencil_at<BSpline2>(g, x, Vec<axes>::Zero()),
                  [&](const Node& n, double w) { at(n) += share * w; });
    }
  }
  // what lies behind the mirrors at the first and, of all axes but y, at the last node
  for (int axis = 0; axis < axes; ++axis) {
    const int wall = field.last[static_cast<std::size_t>(axis)];
    for (std::size_t k = 0; k < count; ++k) {
      Node n = raw.node(k);
      for (int& i : n) --i;
      int& i = n[static_cast<std::size_t>(axis)];
      const auto fold = [&](int mirror, int inwards) {
        if (i == mirror) at(n) *= 2;
        if (i != mirror + inwards) return;
        Node image = n;
        image[static_cast<std::size_t>(axis)] = mirror - inwards;
        at(n) += at(image);
      };
      fold(0, 1);
      if (axis + 1 < axes) fold(wall, -1);
    }
  }
  std::size_t nodes = 1;
  for (int axis = 0; axis < axes; ++axis) nodes *= static_cast<std::size_t>(field.nodes(axis));
  field.fraction.reserve(nodes);
  for (std::size_t k = 0; k < nodes; ++k) field.fraction.push_back(at(field.node(k)));
  return field;
}

template <int axes>
BasicVoidArea<axes>::BasicVoidArea(const Vec<axes>& center, double radius, bool full, int particles_per_cell)
    : center_(center),
      radius_(radius),
      full_(full),
      points_per_particle_(particles_per_cell > 1 ? 1 : 1 << axes),
      points_per_edge_square_(axes == 2 ? points_per_particle_ * particles_per_cell
                                        : static_cast<int>(std::lround(std::pow(
                                              std::cbrt(points_per_particle_ * particles_per_cell), 2)))) {}

namespace {

/// The place of a node [m].
Vec2 place_of(const BasicIndicator<2>& f, const Vec2& origin, const std::array<int, 2>& n) {
  return origin + Vec2(n[0] * f.cell.x(), n[1] * f.cell.y());
}
Vec3 place_of(const BasicIndicator<3>& f, const Vec3& origin, const std::array<int, 3>& n) {
  return origin + Vec3(n[0] * f.cell.x(), n[2] * f.cell.y(), n[1] * f.cell.z());
}
/// From a vertical line [m].
double beside(const Vec2& x, const Vec2& line) { return std::abs(x.x() - line.x()); }
double beside(const Vec3& x, const Vec3& line) { return std::hypot(x.x() - line.x(), x.z() - line.z()); }

/// Calls use(node) for the nodes around and at this one, and beyond the ends.
template <std::size_t axes, class Use>
void each_around(const std::array<int, axes>& node, Use use) {
  int count = 1;
  for (std::size_t axis = 0; axis < axes; ++axis) count *= 3;
  for (int k = 0; k < count; ++k) {
    std::array<int, axes> n = node;
    for (int rest = k; int& i : n) i += rest % 3 - 1, rest /= 3;
    use(n);
  }
}

/// Marks all empty nodes that are connected to the marked ones; returns how many are marked in all.
template <int axes>
int spread(const BasicIndicator<axes>& f, std::vector<char>& region, std::vector<std::size_t> front) {
  int count = static_cast<int>(front.size());
  while (!front.empty()) {
    const std::size_t k = front.back();
    const auto node = f.node(k);
    front.pop_back();
    std::size_t stride = 1;
    for (int axis = 0; axis < axes; ++axis) {
      const int i = node[static_cast<std::size_t>(axis)];
      const auto visit = [&](std::size_t next) {
        if (region[next] || !f.empty(next)) return;
        region[next] = 1;
        ++count;
        front.push_back(next);
      };
      if (i > 0) visit(k - stride);
      if (i + 1 < f.nodes(axis)) visit(k + stride);
      stride *= static_cast<std::size_t>(f.nodes(axis));
    }
  }
  return count;
}

/// Empty regions of `smallest` nodes or more that reach neither the topmost row, which is above every
/// particle, nor the lowest, where a body leaves the wall.
template <int axes>
int count_closed(const BasicIndicator<axes>& f) {
  constexpr int smallest = 1 << axes;
  std::vector<char> seen(f.fraction.size(), 0);
  std::vector<std::size_t> outside;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const int row = f.node(k)[axes - 1];
    if ((row > 0 && row < f.rows()) || !f.empty(k)) continue;
    seen[k] = 1;
    outside.push_back(k);
  }
  spread(f, seen, std::move(outside));
  int regions = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (seen[k] || !f.empty(k)) continue;
    seen[k] = 1;
    regions += spread(f, seen, {k}) >= smallest;
  }
  return regions;
}

}  // namespace

/// Empty nodes of the cavity at the start; later, empty nodes of or beside the last region.
template <int axes>
void BasicVoidArea<axes>::seed(const Indicator& f, const Vec<axes>& origin, std::vector<char>& region) const {
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (!f.empty(k)) continue;
    bool inside = false;
    if (!started_) {
      inside = (place_of(f, origin, f.node(k)) - center_).norm() < radius_;
    } else {
      each_around(f.node(k), [&](const typename Indicator::Node& n) {
        for (int axis = 0; axis < axes; ++axis)
          if (n[static_cast<std::size_t>(axis)] < 0 || n[static_cast<std::size_t>(axis)] >= f.nodes(axis))
            return;
        const std::size_t near = f.index(n);  // rows come last: there may have been fewer
        inside |= near < previous_.size() && previous_[near] != 0;
      });
    }
    if (inside) region[k] = 1;
  }
}

namespace {

/// The part of a region in a plane, in cells.
struct Section {
  double area = 0, radial = 0;  ///< the latter times its distance from x = 0
  int lowest, highest = 0;      ///< rows of cells that the region has a part of
};

/// index(i, j): of a node of the plane.
template <class Index>
Section section_of(const std::vector<double>& fraction, const std::vector<char>& region, int columns,
                   int rows, Index index) {
  Section sum{.lowest = rows};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::size_t at[4] = {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)};
      double corner[4];
      bool mine = false;
      for (int k = 0; k < 4; ++k) {
        corner[k] = fraction[at[k]];
        mine |= region[at[k]] != 0;
      }
      if (!mine) continue;
      const Part part = empty_part(corner);
      sum.area += part.area;
      sum.radial += i * part.area + part.moment_x;
      sum.lowest = std::min(sum.lowest, j), sum.highest = std::max(sum.highest, j);
    }
  return sum;
}

/// The part of a region in space, in cells.
struct Body3 {
  double volume = 0;
  std::array<int, 3> first, last{};  ///< cells that the region has a part of, along x, z, y
};

Body3 body_of(const BasicIndicator<3>& f, const std::vector<char>& region) {
  Body3 sum{.first = f.last};
  std::array<std::size_t, 8> offset{};
  for (std::size_t k = 0; k < 8; ++k)
    offset[k] = f.index({static_cast<int>(k & 1), static_cast<int>(k >> 1 & 1), static_cast<int>(k >> 2)});
  for (int j = 0; j < f.last[2]; ++j)
    for (int k = 0; k < f.last[1]; ++k)
      for (int i = 0; i < f.last[0]; ++i) {
        const std::size_t low = f.index({i, k, j});
        std::array<double, 8> corner;
        bool mine = false;
        for (std::size_t c = 0; c < 8; ++c) {
          corner[c] = f.fraction[low + offset[c]];
          mine |= region[low + offset[c]] != 0;
        }
        if (!mine) continue;
        sum.volume += empty_part(corner);
        const std::array<int, 3> cell = {i, k, j};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          sum.first[axis] = std::min(sum.first[axis], cell[axis]);
          sum.last[axis] = std::max(sum.last[axis], cell[axis]);
        }
      }
  return sum;
}

}  // namespace

/// `variance`: s^2, in cells; `closed`: which share of a closed surface the region has.
template <>
double BasicVoidArea<2>::measure(const Indicator& f, const std::vector<char>& region, double variance,
                                 double closed) {
  const Section section = section_of(f.fraction, region, f.last[0], f.rows(), [&](int i, int j) {
    return f.index({i, j});
  });
  const double height = section.highest - section.lowest;
  const double cell = f.cell.x() * f.cell.y();
  volume_ = 2 * pi * (section.radial + 0.5 * closed * variance * height) * cell * f.cell.x();
  return ((full_ ? 1 : 2) * section.area + closed * pi * variance) * cell;
}

template <>
double BasicVoidArea<3>::measure(const Indicator& f, const std::vector<char>& region, double variance,
                                 double closed) {
  const Body3 body = body_of(f, region);
  const auto extent = [&](std::size_t axis) {
    const bool halved = !full_ && axis < 2;
    return halved ? 2 * (body.last[axis] + 0.5) : body.last[axis] - body.first[axis];
  };
  const double mean_width = (extent(0) + extent(1) + extent(2)) / 3;
  volume_ = ((full_ ? 1 : 4) * body.volume + 2 * pi * closed * variance * mean_width) * f.cell.prod();
  const int middle = full_ ? f.last[1] / 2 : 0;
  const Section section = section_of(f.fraction, region, f.last[0], f.rows(), [&](int i, int j) {
    return f.index({i, middle, j});
  });
  return ((full_ ? 1 : 2) * section.area + 2 * pi * closed * variance) * f.cell.x() * f.cell.y();
}

template <int axes>
double BasicVoidArea<axes>::update(const BasicState<axes>& s) {
  const Indicator f = indicator_of(s, points_per_particle_);
  std::vector<char> region(f.fraction.size(), 0);
  seed(f, s.grid.origin(), region);

  std::vector<std::size_t> front;
  for (std::size_t k = 0; k < region.size(); ++k)
    if (region[k]) front.push_back(k);
  const bool any = spread(f, region, std::move(front)) > 0;
  closed_regions_ = count_closed(f);

  joined_outside_ = touches_wall_ = false;
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (!region[k]) continue;
    const auto node = f.node(k);
    joined_outside_ |= node[axes - 1] == f.rows();
    if (node[axes - 1] != 0) continue;
    touches_wall_ = true;
    joined_outside_ |=
        beside(place_of(f, s.grid.origin(), node), center_) > radius_ + cells_beside_wall * f.cell.x();
  }
  volume_ = 0;
  const double variance = 1.0 / 4 + 1.0 / 6 - 1.0 / (12.0 * points_per_edge_square_);
  const double closed = joined_outside_ ? 0 : touches_wall_ ? 0.5 : 1;
  const double area = any ? measure(f, region, variance, closed) : 0;
  started_ = true;
  previous_ = std::move(region);
  return area;
}

template <int axes>
void BasicVoidArea<axes>::carry(Archive& a) {
  a.integer("started", started_), a.integer("joined_outside", joined_outside_);
  a.integer("touches_wall", touches_wall_), a.integer("closed_regions", closed_regions_);
  a.number("volume", volume_);
  a.integers("region", previous_);
}

template BasicIndicator<2> indicator_of(const State&, int);
template BasicIndicator<3> indicator_of(const BasicState<3>&, int);
template class BasicVoidArea<2>;
template class BasicVoidArea<3>;

}  // namespace mpm
