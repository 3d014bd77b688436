#pragma once
#include <limits>
#include <string_view>

#include "libmpm/mpm.hpp"
#include "libmpm/verification/exact/elastic_plastic_impact.hpp"

/// Scenes that problems and tests share, with default numerics. Small: with coarse cells a run takes well
/// under a second.
namespace mpm::verification::scenes {

/// The weak collapse of the paper, up to the end of the shock's way through the block.
inline mpm::Scene cavity(double cell_size) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::cavity_impact;
  s.material = mpm::named_material("aluminium");
  s.impact_speed = 200;
  s.block_width = 10e-6;
  s.block_height = 5e-6;
  s.cavity_radius = 1.5e-6;
  s.cavity_center_height = 1.9e-6;
  s.end_time = 1e-9;
  s.numerics = mpm::default_numerics(s.kind);
  s.numerics.cell_size = cell_size;
  s.measures.area_every = 0.05e-9;
  return s;
}

/// A column of a block, eight cells wide in full.
inline mpm::Scene planar(double impact_speed, double height, double cell_size, double end_time) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::planar_impact;
  s.material = mpm::named_material("aluminium");
  s.impact_speed = impact_speed;
  s.block_width = 8 * cell_size;
  s.block_height = height;
  s.end_time = end_time;
  s.numerics = mpm::default_numerics(s.kind);
  s.numerics.cell_size = cell_size;
  s.measures.area_every = end_time / 20;
  return s;
}

/// The aluminium shell of verney_cylinder_al.csv, which stops within 6 ns.
inline mpm::Scene shell(double inner_speed, double cell_size) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::imploding_shell;
  s.material = mpm::named_material("aluminium");
  s.inner_radius = 1.5e-6;
  s.outer_radius = 3e-6;
  s.inner_speed = inner_speed;
  s.end_time = 9e-9;
  s.numerics = mpm::default_numerics(s.kind);
  s.numerics.cell_size = cell_size;
  s.measures.area_every = s.end_time / 100;
  return s;
}

/// The same in another space, with the default numerics there, on the same cells.
inline mpm::Scene in_space(mpm::Space space, mpm::Scene s) {
  const double cell = s.numerics.cell_size;
  s.space = space;
  s.numerics = mpm::default_numerics(s.kind, space);
  s.numerics.cell_size = cell;
  return s;
}

/// Value of a metric; `otherwise` if the run has none of that name.
inline double metric(const mpm::RunResult& r, std::string_view name,
                     double otherwise = std::numeric_limits<double>::quiet_NaN()) {
  for (const mpm::Metric& m : r.metrics)
    if (m.name == name) return m.value;
  return otherwise;
}

/// The material as exact solutions take it. Its hardening is isotropic there.
inline exact::ElasticPlasticSolid exact_solid(const mpm::Material& m) {
  return {{m.reference_density, m.bulk_sound_speed, m.hugoniot_slope, m.gruneisen_gamma, m.specific_heat,
           m.initial_temperature},
          m.shear_modulus(),
          m.yield_stress,
          m.hardening_per_equivalent_strain()};
}

}  // namespace mpm::verification::scenes
