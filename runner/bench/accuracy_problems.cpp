#include <cmath>
#include <limits>

#include "libmpm/exact/elastic_plastic_impact.hpp"
#include "libmpm/exact/lagrangian_1d.hpp"
#include "runner/bench/accuracy_bench.hpp"

namespace mpmstudy {
namespace {

constexpr double um = 1e-6, ns = 1e-9;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double metric(const mpm::RunResult& r, const std::string& name) {
  for (const mpm::Metric& m : r.metrics)
    if (m.name == name) return m.value;
  return nan;
}

mpm::Scene scene_of(mpm::SceneKind kind) {
  mpm::Scene s;
  s.kind = kind;
  s.material = mpm::named_material("aluminium");
  s.numerics = mpm::default_numerics(kind);
  return s;
}

mpm::exact::ElasticPlasticSolid solid_of(const mpm::Material& m) {
  return {{m.reference_density, m.bulk_sound_speed, m.hugoniot_slope, m.gruneisen_gamma, m.specific_heat,
           m.initial_temperature},
          m.shear_modulus(),
          m.yield_stress,
          m.hardening_per_equivalent_strain()};
}

AccuracyProblem planar(const char* name, const char* what, double speed, double exact) {
  mpm::Scene s = scene_of(mpm::SceneKind::planar_impact);
  s.impact_speed = speed;
  s.block_height = 20 * um;
  s.block_width = 3.2 * um;  // eight cells of the coarsest rung, the fewest that are allowed
  s.end_time = 3.6 * ns;
  s.measures.area_every = s.end_time / 20;
  s.numerics.cell_size = 0.4 * um;
  const std::string number = what;
  return {name,
          what,
          s,
          4,
          [number](const mpm::RunResult& r) { return metric(r, number); },
          [exact] { return exact; }};
}

AccuracyProblem shell() {
  mpm::Scene s = scene_of(mpm::SceneKind::imploding_shell);
  s.inner_radius = 1.5 * um;
  s.outer_radius = 3 * um;
  s.inner_speed = 185.0293;  // a row of verney_cylinder_al.csv
  s.end_time = 9 * ns;
  s.measures.area_every = s.end_time / 100;
  s.numerics.cell_size = 0.3 * um;
  return {"imploding-shell",
          "stop_radius_m",
          s,
          4,
          [](const mpm::RunResult& r) { return metric(r, "stop_radius_m"); },
          [s] {
            constexpr int shells = 120;
            return mpm::exact::compressible_shell_stop(solid_of(s.material), s.inner_radius, s.outer_radius,
                                                       s.inner_speed, shells)
                .radius;
          }};
}

AccuracyProblem weak_collapse() {
  mpm::Scene s = scene_of(mpm::SceneKind::cavity_impact);
  s.impact_speed = 200;
  s.block_width = 10 * um;
  s.block_height = 5 * um;
  s.cavity_radius = 1.5 * um;
  s.cavity_center_height = 1.9 * um;
  s.end_time = 16 * ns;
  s.measures.area_every = 0.05 * ns;
  s.numerics.cell_size = 0.4 * um;
  return {"weak-collapse",
          "collapsibility",
          s,
          4,
          [](const mpm::RunResult& r) { return r.collapsibility.value_or(nan); },
          {}};
}

/// The wall beyond the cavity is 2 um thick: near the critical speed of its ejection.
AccuracyProblem strong_collapse() {
  mpm::Scene s = weak_collapse().scene;
  s.impact_speed = 500;
  s.block_height = 10 * um;
  s.cavity_center_height = 6.5 * um;
  s.end_time = 6 * ns;
  return {"strong-collapse",
          "largest_collapsibility",
          s,
          4,
          [](const mpm::RunResult& r) { return metric(r, "largest_collapsibility"); },
          {}};
}

}  // namespace

std::vector<AccuracyProblem> accuracy_problems() {
  const auto exact = [](double speed) {
    return mpm::exact::elastic_plastic_impact(solid_of(mpm::named_material("aluminium")), speed);
  };
  const auto weak = exact(200), strong = exact(1120);
  return {planar("planar-1120-stress", "shock_normal_stress_Pa", 1120, strong.normal_stress),
          planar("planar-1120-deviator", "shock_von_mises_Pa", 1120, strong.von_mises),
          planar("planar-200-stress", "shock_normal_stress_Pa", 200, weak.normal_stress),
          shell(),
          weak_collapse(),
          strong_collapse()};
}

}  // namespace mpmstudy
