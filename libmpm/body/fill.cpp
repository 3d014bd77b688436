#include "libmpm/body/fill.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/core/errors.hpp"

namespace mpm {
namespace {

constexpr double smallest_fraction = 0.05;
constexpr double rounding = 1e-9;  ///< of a share: an edge on a line of the lattice may miss it by this

/// What a region leaves of a rectangle.
struct Remainder {
  double fraction = 1;
  Vec2 centroid;
};

/// Midpoint rule over thin vertical strips, exact in the height of each strip.
Remainder remainder(const Region& region, const Vec2& center, const Vec2& size,
                    std::vector<Interval>& intervals) {
  switch (region.share_of_circle(center, 0.5 * size.norm())) {
    case Share::all:
      return {1, center};
    case Share::none:
      return {0, center};
    case Share::part:
      break;
  }
  constexpr int strips = 64;
  const double bottom = center.y() - 0.5 * size.y(), top = center.y() + 0.5 * size.y();
  double area = 0, moment_x = 0, moment_y = 0;
  for (int k = 0; k < strips; ++k) {
    const double x = center.x() + size.x() * ((k + 0.5) / strips - 0.5);
    intervals.clear();
    region.cut(x, intervals);
    double length = 0, moment = 0;
    for (const Interval& i : intervals) {
      const double low = std::max(i.low, bottom), high = std::min(i.high, top);
      if (!(high > low)) continue;
      length += high - low;
      moment += (high - low) * (high + low);
    }
    area += length;
    moment_x += length * x;
    moment_y += 0.5 * moment;
  }
  if (area == 0) return {0, center};
  return {area / (strips * size.y()), Vec2(moment_x / area, moment_y / area)};
}

/// Number of the share of the lattice that a place lies in.
std::pair<long, long> share_at(const State& s, const Vec2& share, const Vec2& x) {
  const Vec2 at = (x - s.grid.origin()).cwiseQuotient(share);
  return {std::lround(std::floor(at.x())), std::lround(std::floor(at.y()))};
}

/// Throws where the particles from `first` on share a place with those before.
void refuse_overlap(const State& s, std::size_t first, const Vec2& share) {
  std::map<std::pair<long, long>, double> filled;
  const Particles& ps = s.particles;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    double& volume = filled[share_at(s, share, ps.position[p])];
    if (p >= first && volume + area(s, p) > 1.01 * share.x() * share.y())
      throw InputError("two bodies overlap at x = " + std::to_string(ps.position[p].x() * 1e6) + " um, y = " +
                       std::to_string(ps.position[p].y() * 1e6) + " um: take one region from the other");
    volume += area(s, p);
  }
}

}  // namespace

State empty_state(Vec2 low, Vec2 cell, int columns, Floor floor, Space space) {
  if (space == Space::axisymmetric && low.x() != 0)
    throw InputError("in axisymmetry the left side of the grid is the axis, x = 0; not " +
                     std::to_string(low.x()) + " m");
  return {{}, Grid(low, cell, columns), {}, 0, 0, floor, space};
}

void fill_rows(State& s, const Body& body, double density, int particles_per_edge, int first, int last) {
  const int side = particles_per_edge;
  const Grid& grid = s.grid;
  const Vec2 share = grid.cell() / side;
  std::vector<Interval> intervals;
  for (int j = first * side; j < last * side; ++j)
    for (int i = 0; i < grid.columns() * side; ++i) {
      const Vec2 center = grid.origin() + Vec2((i + 0.5) * share.x(), (j + 0.5) * share.y());
      const Remainder r = remainder(body.region, center - body.place, share, intervals);
      if (r.fraction < smallest_fraction) continue;
      const double volume = r.fraction * (share.x() * share.y());
      const Vec2 position = r.fraction == 1 ? center : Vec2(body.place + r.centroid);
      // integral of the radius over an area: the area times the radius of its centroid
      const double radius = s.space == Space::axisymmetric ? position.x() : 1;
      s.particles.add(position, body.velocity(r.centroid), density * (volume * radius), volume * radius,
                      0.5 * std::sqrt(r.fraction) * share);
    }
  s.velocity_gradient.assign(s.particles.size(), Mat2::Zero());
}

void fill(State& s, const Body& body, const Scene& scene) {
  const Grid& grid = s.grid;
  const int side = static_cast<int>(std::lround(std::sqrt(scene.numerics.particles_per_cell)));
  const double bottom = body.region.low.y() + body.place.y() - grid.origin().y();
  const double top = body.region.high.y() + body.place.y() - grid.origin().y();
  if (!std::isfinite(bottom) || !std::isfinite(top))
    throw InputError("a body must end above and below: its region goes from y = " + std::to_string(bottom) +
                     " to " + std::to_string(top));
  const double height = grid.cell().y();
  const std::size_t before = s.particles.size();
  fill_rows(s, body, scene.material.reference_density, side,
            std::max(0, static_cast<int>(std::floor(bottom / height + rounding))),
            static_cast<int>(std::ceil(top / height - rounding)));
  if (s.particles.size() == before)
    throw InputError("a body lies outside of the grid, or is too small for it");
  refuse_overlap(s, before, grid.cell() / side);
}

}  // namespace mpm
