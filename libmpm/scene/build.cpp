#include "libmpm/scene/build.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/body/fill.hpp"

namespace mpm {
namespace {

/// About the centre of the cavity or of the shell.
Region region_of(const Scene& s) {
  switch (s.kind) {
    case SceneKind::planar_impact:
      return everywhere();
    case SceneKind::cavity_impact:
    case SceneKind::two_body_impact:
      return everywhere() - disc({0, 0}, s.cavity_radius);
    case SceneKind::imploding_shell:
      return disc({0, 0}, s.outer_radius) - disc({0, 0}, s.inner_radius);
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
  const bool quarter = s.kind == SceneKind::imploding_shell && s.numerics.symmetry == Symmetry::half;
  State state = empty_state(l.origin, l.cell, l.columns, quarter ? Floor::mirror : Floor::impact_wall);
  state.particles.reserve(static_cast<std::size_t>(l.columns * l.rows * side * side));
  const auto velocity = [&](const Vec2& x) { return velocity_at(s, x, l.center.y() + x.y()); };
  fill_rows(state, {region_of(s), velocity, l.center}, s.material.reference_density, side, l.empty_rows,
            l.rows);
  if (std::isfinite(s.material.yield_stress) && s.material.kinematic_fraction > 0)
    state.particles.back_stress.resize(state.particles.size());
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
