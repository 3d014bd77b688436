#include "libmpm/scene/build.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {
namespace {

/// What is left of a rectangle outside of a disk.
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

/// Midpoint rule over thin vertical strips, exact in each strip's height. Coordinates are relative to the
/// disk's centre.
Remainder remainder(const Vec2& center, const Vec2& size, double radius) {
  const double reach = 0.5 * size.norm();
  if (center.norm() > radius + reach) return {1, center};
  if (center.norm() < radius - reach) return {0, center};
  constexpr int strips = 64;
  double area = 0, moment_x = 0, moment_y = 0;
  for (int k = 0; k < strips; ++k) {
    const double x = center.x() + size.x() * ((k + 0.5) / strips - 0.5);
    const double chord = x * x < radius * radius ? std::sqrt(radius * radius - x * x) : 0;
    const Cut c = outside(center.y() - 0.5 * size.y(), center.y() + 0.5 * size.y(), -chord, chord);
    area += c.length;
    moment_x += c.length * x;
    moment_y += c.moment;
  }
  if (area == 0) return {0, center};
  return {area / (strips * size.y()), Vec2(moment_x / area, moment_y / area)};
}

constexpr double smallest_fraction = 0.05;

}  // namespace

Lattice lattice_of(const Scene& s) {
  const bool half = s.numerics.symmetry == Symmetry::half;
  Lattice l;
  // The half width is cut, so that the mirror axis lies on nodes in both descriptions.
  const double half_width = s.block_width / 2;
  const int half_columns = std::max(1, static_cast<int>(std::lround(half_width / s.numerics.cell_size)));
  l.rows = std::max(1, static_cast<int>(std::lround(s.block_height / s.numerics.cell_size)));
  l.cell = Vec2(half_width / half_columns, s.block_height / l.rows);
  l.columns = half ? half_columns : 2 * half_columns;
  l.width = half ? half_width : s.block_width;
  l.origin = Vec2(half ? 0 : -half_width, 0);
  return l;
}

State build_state(const Scene& s) {
  const Lattice l = lattice_of(s);
  const int side = static_cast<int>(std::lround(std::sqrt(s.numerics.particles_per_cell)));
  const Vec2 share = l.cell / side;
  const double share_area = share.x() * share.y();
  const Vec2 velocity(0, -s.impact_speed);
  const Vec2 cavity(0, s.cavity_center_height);
  const bool has_cavity = s.kind == SceneKind::cavity_impact;

  State state{{}, Grid(l.origin, l.cell, l.columns), {}, 0, 0};
  Particles& ps = state.particles;
  ps.reserve(static_cast<std::size_t>(l.columns * l.rows * side * side));
  for (int j = 0; j < l.rows * side; ++j)
    for (int i = 0; i < l.columns * side; ++i) {
      const Vec2 center = l.origin + Vec2((i + 0.5) * share.x(), (j + 0.5) * share.y());
      Remainder r{1, center - cavity};
      if (has_cavity) r = remainder(center - cavity, share, s.cavity_radius);
      if (r.fraction < smallest_fraction) continue;
      const double volume = r.fraction * share_area;
      const Vec2 position = r.fraction == 1 ? center : Vec2(cavity + r.centroid);
      ps.add(position, velocity, s.material.reference_density * volume, volume,
             0.5 * std::sqrt(r.fraction) * share);
    }
  if (s.material.kinematic_fraction > 0) ps.back_stress.resize(ps.size());
  state.velocity_gradient.assign(ps.size(), Mat2::Zero());
  return state;
}

MaterialModel build_material(const Scene& s) {
  return {MieGrueneisen(s.material),
          J2(s.material),
          {s.numerics.linear_viscosity, s.numerics.quadratic_viscosity, s.numerics.cell_size}};
}

}  // namespace mpm
