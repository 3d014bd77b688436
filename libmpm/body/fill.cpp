#include "libmpm/body/fill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "libmpm/core/errors.hpp"

namespace mpm {
namespace {

/// Of a share, with the same edge in squares and in cubes.
constexpr double smallest_fraction(int axes) { return axes == 2 ? 0.05 : 0.011; }
constexpr double rounding = 1e-9;  ///< of a share: an edge on a line of the lattice may miss it by this

/// Of thin strips of the height of a share, standing on its base.
template <int axes>
struct Strips;
template <>
struct Strips<2> {
  static constexpr int count = 64;
  double from, size;

  Strips(const Vec2& center, const Vec2& share) : from(center.x()), size(share.x()) {}
  double line(int k) const { return from + size * ((k + 0.5) / count - 0.5); }
  static Vec2 point(double x, double y) { return {x, y}; }
};
template <>
struct Strips<3> {
  static constexpr int edge = 16, count = edge * edge;
  Vec2 from, size;

  Strips(const Vec3& center, const Vec3& share) : from(center.x(), center.z()), size(share.x(), share.z()) {}
  Vec2 line(int k) const {
    return from + size.cwiseProduct(Vec2((k % edge + 0.5) / edge - 0.5, (k / edge + 0.5) / edge - 0.5));
  }
  static Vec3 point(const Vec2& at, double y) { return {at.x(), y, at.y()}; }
};

/// What a region leaves of a box.
template <int axes>
struct Remainder {
  double fraction = 1;
  Vec<axes> centroid;
};

/// Midpoint rule over thin vertical strips, exact in the height of each strip.
template <int axes>
Remainder<axes> remainder(const BasicRegion<axes>& region, const Vec<axes>& center, const Vec<axes>& size,
                          std::vector<Interval>& intervals) {
  switch (region.share_of_ball(center, 0.5 * size.norm())) {
    case Share::all:
      return {1, center};
    case Share::none:
      return {0, center};
    case Share::part:
      break;
  }
  const Strips<axes> strips(center, size);
  const double bottom = center.y() - 0.5 * size.y(), top = center.y() + 0.5 * size.y();
  double sum = 0;
  Vec<axes> moment = Vec<axes>::Zero();
  for (int k = 0; k < strips.count; ++k) {
    const LineAt<axes> line = strips.line(k);
    intervals.clear();
    region.cut(line, intervals);
    double length = 0, twice_moment = 0;
    for (const Interval& i : intervals) {
      const double low = std::max(i.low, bottom), high = std::min(i.high, top);
      if (!(high > low)) continue;
      length += high - low;
      twice_moment += (high - low) * (high + low);
    }
    sum += length;
    moment += strips.point(length * line, 0.5 * twice_moment);
  }
  if (sum == 0) return {0, center};
  return {sum / (strips.count * size.y()), moment / sum};
}

/// Number of the share of the lattice that a place lies in.
template <int axes>
using ShareNumber = std::array<long, axes>;
template <int axes>
ShareNumber<axes> share_at(const BasicState<axes>& s, const Vec<axes>& share, const Vec<axes>& x) {
  const Vec<axes> at = (x - s.grid.origin()).cwiseQuotient(share);
  ShareNumber<axes> number;
  for (int k = 0; k < axes; ++k) number[static_cast<std::size_t>(k)] = std::lround(std::floor(at[k]));
  return number;
}

/// Throws where the particles from `first` on share a place with those before.
template <int axes>
void refuse_overlap(const BasicState<axes>& s, std::size_t first, const Vec<axes>& share) {
  if (first == 0) return;  // there are none: each share is filled once
  std::map<ShareNumber<axes>, double> sums;
  const auto& ps = s.particles;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    double& volume = sums[share_at(s, share, ps.position[p])];
    if (p >= first && volume + filled(s, p) > 1.01 * share.prod()) {
      std::string place;
      for (int k = 0; k < axes; ++k)
        place += std::string(k == 0 ? "" : ", ") + "xyz"[k] + " = " +
                 std::to_string(ps.position[p][k] * 1e6) + " um";
      throw InputError("two bodies overlap at " + place + ": take one from the other");
    }
    volume += filled(s, p);
  }
}

/// Calls use(centre) for every share of the lattice in rows of shares [first, last), in the order of the
/// grid's nodes.
template <class Use>
void each_share(const Grid& grid, int side, int first, int last, Use use) {
  const Vec2 share = grid.cell() / side;
  for (int j = first; j < last; ++j)
    for (int i = 0; i < grid.columns() * side; ++i)
      use(Vec2(grid.origin() + Vec2((i + 0.5) * share.x(), (j + 0.5) * share.y())));
}
template <class Use>
void each_share(const BasicGrid<3>& grid, int side, int first, int last, Use use) {
  const Vec3 share = grid.cell() / side;
  for (int j = first; j < last; ++j)
    for (int k = 0; k < grid.slices() * side; ++k)
      for (int i = 0; i < grid.columns() * side; ++i)
        use(Vec3(grid.origin() + Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(share)));
}

}  // namespace

State empty_state(Vec2 low, Vec2 cell, int columns, Floor floor, Space space) {
  if (space == Space::axisymmetric && low.x() != 0)
    throw InputError("in axisymmetry the left side of the grid is the axis, x = 0; not " +
                     std::to_string(low.x()) + " m");
  return {{}, Grid(low, cell, columns), {}, 0, 0, floor, space};
}

BasicState<3> empty_state(Vec3 low, Vec3 cell, int columns, int slices, Floor floor) {
  return {{}, BasicGrid<3>(low, cell, columns, slices), {}, 0, 0, floor};
}

template <int axes>
void fill_rows(BasicState<axes>& s, const BasicBody<axes>& body, double density, int side, int first,
               int last) {
  const Vec<axes> share = s.grid.cell() / side;
  std::vector<Interval> intervals;
  each_share(s.grid, side, first * side, last * side, [&](const Vec<axes>& center) {
    const Remainder<axes> r = remainder<axes>(body.region, center - body.place, share, intervals);
    if (r.fraction < smallest_fraction(axes)) return;
    const double left = r.fraction * share.prod();
    const Vec<axes> position = r.fraction == 1 ? center : Vec<axes>(body.place + r.centroid);
    // integral of the radius over an area: the area times the radius of its centroid
    const double radius = s.space == Space::axisymmetric ? position.x() : 1;
    const double edge = axes == 2 ? std::sqrt(r.fraction) : std::cbrt(r.fraction);
    s.particles.add(position, body.velocity(r.centroid), density * (left * radius), left * radius,
                    0.5 * edge * share);
  });
  s.velocity_gradient.assign(s.particles.size(), Mat<axes>::Zero());
}

int particles_per_edge(const Numerics& n, int axes) {
  return static_cast<int>(
      std::lround(axes == 2 ? std::sqrt(n.particles_per_cell) : std::cbrt(n.particles_per_cell)));
}

template <int axes>
void fill(BasicState<axes>& s, const BasicBody<axes>& body, const Scene& scene, std::size_t material) {
  const auto& grid = s.grid;
  const int side = particles_per_edge(scene.numerics, axes);
  const double bottom = body.region.low.y() + body.place.y() - grid.origin().y();
  const double top = body.region.high.y() + body.place.y() - grid.origin().y();
  if (!std::isfinite(bottom) || !std::isfinite(top))
    throw InputError("a body must end above and below: its region goes from y = " + std::to_string(bottom) +
                     " to " + std::to_string(top));
  const double height = grid.cell().y();
  const std::size_t before = s.particles.size();
  std::vector<std::size_t>& ends = s.particles.material_ends;
  if (ends.size() > material + 1)
    throw InputError("material = " + std::to_string(material) + ": must be " +
                     std::to_string(ends.size() - 1) +
                     " or more: bodies are filled in the order of their materials");
  fill_rows(s, body, material_of(scene, material).reference_density, side,
            std::max(0, static_cast<int>(std::floor(bottom / height + rounding))),
            static_cast<int>(std::ceil(top / height - rounding)));
  if (s.particles.size() == before)
    throw InputError("a body lies outside of the grid, or is too small for it");
  if (material > 0 || !ends.empty()) {
    ends.resize(material + 1, before);
    ends.back() = s.particles.size();
  }
  refuse_overlap<axes>(s, before, grid.cell() / side);
}

template void fill(State&, const Body&, const Scene&, std::size_t);
template void fill(BasicState<3>&, const BasicBody<3>&, const Scene&, std::size_t);
template void fill_rows(State&, const Body&, double, int, int, int);
template void fill_rows(BasicState<3>&, const BasicBody<3>&, double, int, int, int);

}  // namespace mpm
