#include "libmpm/core/particles.hpp"

namespace mpm {

void Particles::reserve(std::size_t n) {
  position.reserve(n);
  velocity.reserve(n);
  mass.reserve(n);
  initial_volume.reserve(n);
  dilation.reserve(n);
  energy.reserve(n);
  pressure.reserve(n);
  viscous_pressure.reserve(n);
  deviator.reserve(n);
  plastic_strain.reserve(n);
  plastic_work.reserve(n);
  half_size.reserve(n);
}

void Particles::add(Vec2 x, Vec2 v, double m, double v0, Vec2 half) {
  position.push_back(x);
  velocity.push_back(v);
  mass.push_back(m);
  initial_volume.push_back(v0);
  dilation.push_back(0);
  energy.push_back(0);
  pressure.push_back(0);
  viscous_pressure.push_back(0);
  deviator.push_back({});
  plastic_strain.push_back(0);
  plastic_work.push_back(0);
  half_size.push_back(half);
}

}  // namespace mpm
