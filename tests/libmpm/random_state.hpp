#pragma once
#include <random>

#include "libmpm/scene/build.hpp"

/// A block with random velocities (a fifth of the sound speed) and random stresses, `lift` above the wall.
template <int axes = 2>
mpm::BasicState<axes> random_state(const mpm::Scene& scene, double lift) {
  mpm::BasicState<axes> s = mpm::build_state<axes>(scene);
  std::mt19937 generator(7);
  const auto random = [&] { return generator() / 2147483648.0 - 1; };
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    s.particles.position[p].y() += lift;
    for (int a = axes - 1; a >= 0; --a) s.particles.velocity[p][a] = 1000 * random();
    s.particles.pressure[p] = 5e9 * random();
    mpm::Tensor<axes> t{1e8 * random(), 1e8 * random(), 1e8 * random(), 1e8 * random()};
    if constexpr (axes == 3) t.xz = 1e8 * random(), t.yz = 1e8 * random();
    s.particles.deviator[p] = mpm::plus_mean(t, -(t.xx + t.yy + t.zz) / 3);
    s.particles.energy[p] = 1e5 * random();
  }
  return s;
}
