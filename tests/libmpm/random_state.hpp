#pragma once
#include <random>

#include "libmpm/scene/build.hpp"

/// A block with random velocities (a fifth of the sound speed) and random stresses, `lift` above the wall.
inline mpm::State random_state(const mpm::Scene& scene, double lift) {
  mpm::State s = mpm::build_state(scene);
  std::mt19937 generator(7);
  const auto random = [&] { return generator() / 2147483648.0 - 1; };
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    s.particles.position[p].y() += lift;
    s.particles.velocity[p] = 1000 * mpm::Vec2(random(), random());
    s.particles.pressure[p] = 5e9 * random();
    const mpm::PlaneTensor t{1e8 * random(), 1e8 * random(), 1e8 * random(), 1e8 * random()};
    const double mean = (t.xx + t.yy + t.zz) / 3;
    s.particles.deviator[p] = {t.xx - mean, t.yy - mean, t.zz - mean, t.xy};
    s.particles.energy[p] = 1e5 * random();
  }
  return s;
}
