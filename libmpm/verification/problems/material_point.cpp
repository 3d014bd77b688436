#include "libmpm/verification/problems/material_point.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/step/stress_update.hpp"
#include "libmpm/verification/exact/root.hpp"

namespace mpm::verification {

MaterialPoint::MaterialPoint(const mpm::Material& m)
    : state_{{}, mpm::Grid({0, 0}, {1, 1}, 1), {}, 0, 0, mpm::Floor::mirror}, model_{m, {0, 0, 1}} {
  state_.particles.add({0.5, 0.5}, {0, 0}, m.reference_density, 1, {0.5, 0.5});
  state_.particles.keep(mpm::state_columns(m));
  state_.velocity_gradient.push_back(mpm::Mat2::Zero());
}

MaterialPoint::MaterialPoint(const mpm::Material& m, const exact::ImpactState& shocked) : MaterialPoint(m) {
  mpm::Particles& ps = state_.particles;
  ps.dilation[0] = m.reference_density / shocked.density - 1;
  ps.energy[0] = shocked.specific_energy;
  ps.pressure[0] = mpm::MieGrueneisen(m).pressure(mpm::MieGrueneisen::Volume(ps.dilation[0]), ps.energy[0]);
  const double q = shocked.von_mises;
  ps.deviator[0] = {q / 3, -2 * q / 3, q / 3, 0};
  ps.own_values("plastic_strain")[0] = shocked.equivalent_plastic_strain;
  strain_ = std::log(shocked.density / m.reference_density);
}

/// The step of time is 1: only the strain counts. Between two steps the energy is that of the whole step, by
/// the trapezoidal rule de = -sigma dV; the update wants it at the middle, so half is added before and half
/// after.
void MaterialPoint::step(double change) {
  mpm::Particles& ps = state_.particles;
  const double growth = std::expm1(-change), before = normal_stress(), volume = 1 / density();
  ps.energy[0] -= 0.5 * before * volume * growth;
  state_.velocity_gradient[0] << 0, 0, 0, growth;
  mpm::StepReport report;
  mpm::update_stress(state_, model_, 1, report);
  ps.energy[0] -= 0.5 * normal_stress() * volume * growth;
  strain_ += change;
  speed_ += std::sqrt(std::max((normal_stress() - before) * (volume - 1 / density()), 0.0));
}

void MaterialPoint::strain_to(double strain, int steps) {
  const double change = (strain - strain_) / steps;
  for (int k = 0; k < steps; ++k) step(change);
}

double MaterialPoint::density() const { return state_.particles.density(0); }
double MaterialPoint::normal_stress() const { return -state_.particles.stress(0).yy; }
double MaterialPoint::von_mises() const { return -1.5 * state_.particles.deviator[0].yy; }
double MaterialPoint::plastic_strain() const { return state_.particles.own_values("plastic_strain")[0]; }
double MaterialPoint::specific_energy() const { return state_.particles.energy[0]; }

MaterialHugoniot material_hugoniot(const mpm::Material& m, double particle_speed) {
  const mpm::MieGrueneisen eos(m);
  const double up = particle_speed, energy = up * up / 2;
  const auto pressure = [&](double eta) { return eos.pressure(mpm::MieGrueneisen::Volume(-eta), energy); };
  // eta = 1 - rho0/rho; mass and momentum: P eta = rho0 up^2
  const auto excess = [&](double eta) { return pressure(eta) * eta - m.reference_density * up * up; };
  const double eta = exact::bisect(excess, 0, std::min(1.0, 2 / m.gruneisen_gamma));
  const mpm::Temperature temperature(m);
  return {pressure(eta), up / eta, m.reference_density / (1 - eta), temperature(-eta, energy)};
}

}  // namespace mpm::verification
