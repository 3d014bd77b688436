#include <cmath>
#include <limits>

#include "libmpm/verification/exact/elastic_plastic_impact.hpp"
#include "libmpm/verification/exact/lagrangian_1d.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "runner/bench/accuracy_bench.hpp"

namespace mpmstudy {
namespace {

constexpr double um = 1e-6, ns = 1e-9;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

namespace exact = mpm::verification::exact;
namespace scenes = mpm::verification::scenes;
using scenes::metric;

AccuracyProblem planar(const char* name, const char* what, double speed, double exact) {
  // the width is that of the coarsest rung, where eight cells are the fewest that are allowed
  const mpm::Scene s = scenes::planar(speed, 20 * um, 0.4 * um, 3.6 * ns);
  const std::string number = what;
  return {name,
          what,
          s,
          4,
          [number](const mpm::RunResult& r) { return metric(r, number); },
          [exact] { return exact; }};
}

AccuracyProblem shell() {
  const mpm::Scene s = scenes::shell(185.0293, 0.3 * um);  // a row of verney_cylinder_al.csv
  return {"imploding-shell",
          "stop_radius_m",
          s,
          4,
          [](const mpm::RunResult& r) { return metric(r, "stop_radius_m"); },
          [s] {
            constexpr int shells = 120;
            return exact::compressible_shell_stop(scenes::exact_solid(s.material), s.inner_radius,
                                                  s.outer_radius, s.inner_speed, shells)
                .radius;
          }};
}

AccuracyProblem weak_collapse() {
  mpm::Scene s = scenes::cavity(0.4 * um);
  s.end_time = 16 * ns;
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
    return exact::elastic_plastic_impact(scenes::exact_solid(mpm::named_material("aluminium")), speed);
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
