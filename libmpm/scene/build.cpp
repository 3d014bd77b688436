#include "libmpm/scene/build.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

/// The region between two circles about the body's centre. A block with a cavity has no outer circle.
struct Annulus {
  double inner, outer;
};

/// What an annulus leaves of a rectangle.
struct Remainder {
  double fraction = 1;
  Vec2 centroid;
};

/// The part of the vertical segment [bottom, top] that lies outside of [low, high]: length and first moment.
struct Cut {
  double length, moment;
};
Cut outside(double bottom, double top, double low, double high) {
  const double a = std::clamp(low, bottom, top), b = std::clamp(high, bottom, top);
  return {(a - bottom) + (top - b), 0.5 * ((a - bottom) * (a + bottom) + (top - b) * (top + b))};
}

double half_chord(double radius, double x) {
  return std::abs(x) < radius ? std::sqrt(radius * radius - x * x) : 0;
}

/// Midpoint rule over thin vertical strips, exact in each strip's height. Coordinates are relative to the
/// centre of the circles.
Remainder remainder(const Vec2& center, const Vec2& size, const Annulus& kept) {
  const double reach = 0.5 * size.norm(), distance = center.norm();
  if (distance > kept.inner + reach && distance < kept.outer - reach) return {1, center};
  if (distance < kept.inner - reach || distance > kept.outer + reach) return {0, center};
  constexpr int strips = 64;
  double area = 0, moment_x = 0, moment_y = 0;
  for (int k = 0; k < strips; ++k) {
    const double x = center.x() + size.x() * ((k + 0.5) / strips - 0.5);
    const double hole = half_chord(kept.inner, x), body = half_chord(kept.outer, x);
    const double bottom = std::clamp(center.y() - 0.5 * size.y(), -body, body);
    const double top = std::clamp(center.y() + 0.5 * size.y(), -body, body);
    const Cut c = outside(bottom, top, -hole, hole);
    area += c.length;
    moment_x += c.length * x;
    moment_y += c.moment;
  }
  if (area == 0) return {0, center};
  return {area / (strips * size.y()), Vec2(moment_x / area, moment_y / area)};
}

constexpr double smallest_fraction = 0.05;

Annulus body_of(const Scene& s) {
  switch (s.kind) {
    case SceneKind::planar_impact:
      return {-everywhere, everywhere};
    case SceneKind::cavity_impact:
    case SceneKind::two_body_impact:
      return {s.cavity_radius, everywhere};
    case SceneKind::imploding_shell:
      return {s.inner_radius, s.outer_radius};
  }
  return {};
}

/// At a place relative to the centre; height above the impact face.
Vec2 velocity_at(const Scene& s, const Vec2& x, double height) {
  if (s.kind != SceneKind::imploding_shell) return {0, height < 0 ? s.impact_speed : -s.impact_speed};
  return -s.inner_speed * s.inner_radius / x.squaredNorm() * x;
}

Lattice lattice_of_shell(const Scene& s, bool half) {
  const double h = s.numerics.cell_size;
  const int cells = static_cast<int>(std::ceil(s.outer_radius / h)) + 2;
  const int across = half ? cells : 2 * cells;
  return {half ? Vec2(0, 0) : Vec2(-cells * h, 0),
          Vec2(h, h),
          half ? Vec2(0, 0) : Vec2(0, cells * h),
          across * h,
          across,
          across,
          0};
}

}  // namespace

Lattice lattice_of(const Scene& s) {
  const bool half = s.numerics.symmetry == Symmetry::half;
  if (s.kind == SceneKind::imploding_shell) return lattice_of_shell(s, half);
  Lattice l;
  // The half width is cut, so that the mirror axis lies on nodes in both descriptions.
  const double half_width = s.block_width / 2;
  const int half_columns = std::max(1, static_cast<int>(std::lround(half_width / s.numerics.cell_size)));
  l.rows = std::max(1, static_cast<int>(std::lround(s.block_height / s.numerics.cell_size)));
  l.cell = Vec2(half_width / half_columns, s.block_height / l.rows);
  l.columns = half ? half_columns : 2 * half_columns;
  l.width = half ? half_width : s.block_width;
  l.empty_rows = 0;
  double bottom = 0;
  if (s.kind == SceneKind::two_body_impact) {
    // The struck block, and below it the way that its rear face goes after the shock, at most at
    // impact_speed.
    const int room = static_cast<int>(std::ceil(s.impact_speed * s.end_time / l.cell.y())) + 4;
    l.empty_rows = room;
    bottom = -(l.rows + room) * l.cell.y();
    l.rows += l.rows + room;
  }
  l.origin = Vec2(half ? 0 : -half_width, bottom);
  l.center = Vec2(0, s.cavity_center_height);
  return l;
}

State build_state(const Scene& s) {
  const Lattice l = lattice_of(s);
  const int side = static_cast<int>(std::lround(std::sqrt(s.numerics.particles_per_cell)));
  const Vec2 share = l.cell / side;
  const double share_area = share.x() * share.y();
  const Annulus body = body_of(s);

  State state{{}, Grid(l.origin, l.cell, l.columns), {}, 0, 0, Floor::impact_wall};
  if (s.kind == SceneKind::imploding_shell && s.numerics.symmetry == Symmetry::half)
    state.floor = Floor::mirror;
  Particles& ps = state.particles;
  ps.reserve(static_cast<std::size_t>(l.columns * l.rows * side * side));
  for (int j = l.empty_rows * side; j < l.rows * side; ++j)
    for (int i = 0; i < l.columns * side; ++i) {
      const Vec2 center = l.origin + Vec2((i + 0.5) * share.x(), (j + 0.5) * share.y());
      const Remainder r = remainder(center - l.center, share, body);
      if (r.fraction < smallest_fraction) continue;
      const double volume = r.fraction * share_area;
      const Vec2 position = r.fraction == 1 ? center : Vec2(l.center + r.centroid);
      ps.add(position, velocity_at(s, r.centroid, center.y()), s.material.reference_density * volume, volume,
             0.5 * std::sqrt(r.fraction) * share);
    }
  if (s.material.kinematic_fraction > 0) ps.back_stress.resize(ps.size());
  state.velocity_gradient.assign(ps.size(), Mat2::Zero());
  return state;
}

double initial_speed(const Scene& s) {
  return s.kind == SceneKind::imploding_shell ? s.inner_speed : s.impact_speed;
}

MaterialModel build_material(const Scene& s) {
  return {MieGrueneisen(s.material),
          J2(s.material),
          {s.numerics.linear_viscosity, s.numerics.quadratic_viscosity, s.numerics.cell_size}};
}

}  // namespace mpm
