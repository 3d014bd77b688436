#include "libmpm/core/particles.hpp"

namespace mpm {

template <int axes>
void BasicParticles<axes>::reserve(std::size_t n) {
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

template <int axes>
void BasicParticles<axes>::add(Vector x, Vector v, double m, double v0, Vector half) {
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

template <int axes>
void carry_particles(BasicParticles<axes>& ps, Archive& a) {
  a.numbers("position", ps.position), a.numbers("velocity", ps.velocity);
  a.numbers("mass", ps.mass), a.numbers("initial_volume", ps.initial_volume);
  a.numbers("dilation", ps.dilation), a.numbers("energy", ps.energy);
  a.numbers("pressure", ps.pressure), a.numbers("viscous_pressure", ps.viscous_pressure);
  a.numbers("deviator", ps.deviator), a.numbers("back_stress", ps.back_stress);
  a.numbers("plastic_strain", ps.plastic_strain), a.numbers("plastic_work", ps.plastic_work);
  a.numbers("half_size", ps.half_size), a.numbers("domain", ps.domain);
  a.numbers("affine", ps.affine), a.numbers("affine_energy", ps.affine_energy);
}

template struct BasicParticles<2>;
template struct BasicParticles<3>;
template void carry_particles(BasicParticles<2>&, Archive&);
template void carry_particles(BasicParticles<3>&, Archive&);

}  // namespace mpm
