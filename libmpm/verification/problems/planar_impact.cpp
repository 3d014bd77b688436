#include <utility>

#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "libmpm/verification/problems/with_options.hpp"

namespace mpm::verification {

ExactNumbers planar_impact_numbers(double impact_speed, const ExactOptions& options) {
  mpm::Scene scene = scenes::planar(impact_speed, 1, 1, 1);
  const auto exact_solid = scenes::exact_solid(scene.material);
  const exact::ImpactState exact = exact::elastic_plastic_impact(exact_solid, impact_speed);
  const bool two_waves = exact.structure == exact::WaveStructure::two_waves;
  // Fronts of weak waves are as wide as some micrometres at any cell, and the precursor is steady once it has
  // left the toe of the plastic front behind: a long block. The run ends when the surface's speed is read.
  const double height = two_waves ? 40e-6 : 20e-6;
  scene = with_options(
      scenes::planar(impact_speed, height, 0.05e-6 * options.cells, 1.8 * height / exact.plastic_wave_speed),
      options);
  const mpm::RunResult r = mpm::run(scene);

  ExactNumbers numbers;
  const auto add = [&](const char* quantity, const char* unit, double value, const char* metric,
                       double tolerance) {
    numbers.push_back({quantity, unit, value, scenes::metric(r, metric), tolerance,
                       value == 0 ? Judged::absolute : Judged::relative});
  };
  add("normal stress", "Pa", exact.normal_stress, "shock_normal_stress_Pa", 0.003);
  add("von Mises stress", "Pa", exact.von_mises, "shock_von_mises_Pa", 0.02);
  add("plastic wave speed", "m/s", exact.plastic_wave_speed, "plastic_wave_speed_m_s", 0.003);
  if (two_waves) {
    add("precursor speed", "m/s", exact.elastic_wave_speed, "elastic_wave_speed_m_s", 0.005);
    add("elastic limit stress", "Pa", exact.elastic_limit_stress, "elastic_limit_stress_Pa", 0.03);
  }
  add("free-surface speed", "m/s", exact::simple_release(exact_solid, exact).surface_speed,
      "free_surface_speed_m_s", 0.003);
  add("plateau noise", "1", 0, "plateau_noise", 0.005);
  numbers.push_back({"energy error", "1", 0, r.energy_error, 1e-12, Judged::absolute});
  add("momentum error", "1", 0, "momentum_error", 1e-12);
  return with_trouble(std::move(numbers), r);
}

}  // namespace mpm::verification
