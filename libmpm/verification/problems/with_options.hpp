#pragma once
#include <cmath>

#include "libmpm/simulation.hpp"
#include "libmpm/verification/problems/exact_bench.hpp"

namespace mpm::verification {

/// The scene with the scheme and the particles that were asked for. Its cells are the caller's affair, who
/// makes the scene to fit them.
inline mpm::Scene with_options(mpm::Scene scene, const ExactOptions& options) {
  mpm::Numerics& n = scene.numerics;
  n.scheme = options.scheme.value_or(n.scheme);
  if (options.particles_per_cell) {
    const int square = *options.particles_per_cell;  // of three axes as many to each edge
    n.particles_per_cell =
        scene.space == mpm::Space::three_d ? static_cast<int>(std::lround(std::pow(square, 1.5))) : square;
  }
  if (!mpm::fast_step_has(scene)) n.kernel = mpm::Kernel::reference;
  return scene;
}

/// The numbers of a run with the reason why there are none, if it broke down.
inline ExactNumbers with_trouble(ExactNumbers numbers, const mpm::RunResult& run) {
  if (run.status != mpm::RunStatus::done)
    for (ExactNumber& n : numbers) n.trouble = run.reason;
  return numbers;
}

/// What bodies are computed with that are no scenes: the default of scenes with a cavity.
struct BodyScheme {
  mpm::ShapeFunction shape;
  int side;  ///< particles along each axis of a cell
};
inline BodyScheme body_scheme(const ExactOptions& options) {
  const mpm::Numerics n = mpm::default_numerics(mpm::SceneKind::cavity_impact);
  const int particles = options.particles_per_cell.value_or(n.particles_per_cell);
  return {options.scheme.value_or(n.scheme), static_cast<int>(std::lround(std::sqrt(particles)))};
}

}  // namespace mpm::verification
