#include <algorithm>
#include <utility>

#include "libmpm/verification/lagrangian/collapse.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "libmpm/verification/problems/with_options.hpp"

namespace mpm::verification {

ExactNumbers lagrange_weak_numbers(const ExactOptions& options) {
  mpm::Scene scene = with_options(scenes::cavity(0.1e-6 * options.cells), options);
  scene.end_time = 16e-9;
  constexpr int coarsest_cells = 7;  // to the radius; the limit moves by 0.0006 from there to 10
  const auto code = lagrangian::collapse_ladder(scene, coarsest_cells);
  const auto& meshes = code.meshes;
  const mpm::RunResult r = mpm::run(scene);

  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ExactNumbers numbers = {
      {"collapsibility", "1", code.collapsibility.extrapolated, r.collapsibility.value_or(nan), 0.01}};
  for (const int ns : {1, 2, 3}) {
    const double time = ns * 1e-9;
    const auto limit =
        lagrangian::limit_of(meshes[0].area_at(time), meshes[1].area_at(time), meshes[2].area_at(time));
    const auto sample = std::ranges::min_element(
        r.area_history, {}, [time](const mpm::AreaSample& a) { return std::abs(a.time - time); });
    const double ours = sample == r.area_history.end() ? nan : sample->area;
    numbers.push_back(
        {"open area after " + std::to_string(ns) + " ns", "m2", limit.extrapolated, ours, 0.01});
  }
  // the gap of the wall tracked, and as little linear viscosity as the front needs
  scene.numerics.wall_gap = mpm::WallGap::tracked;
  scene.numerics.linear_viscosity = 0.1;
  numbers.push_back({"collapsibility, gap tracked, q1 = 0.1", "1", code.collapsibility.extrapolated,
                     mpm::run(scene).collapsibility.value_or(nan), 0.005});
  numbers.push_back(
      {"energy error of the Lagrangian code", "1", 0, meshes.back().energy_error, 1e-12, Judged::absolute});
  numbers.push_back(
      {"order of the Lagrangian code", "1", 1.5, code.collapsibility.order, 0.1, Judged::shortfall});
  return with_trouble(std::move(numbers), r);
}

}  // namespace mpm::verification
