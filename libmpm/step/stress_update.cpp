#include "libmpm/step/stress_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm {
namespace {

/// L (1 + dt L/2)^-1: the gradient with respect to positions in the middle of the step.
Mat2 at_middle(const Mat2& l, double dt) {
  const double h = 0.5 * dt;
  const double a = 1 + h * l(0, 0), b = h * l(0, 1), c = h * l(1, 0), d = 1 + h * l(1, 1);
  const double inverse = 1 / (a * d - b * c);
  Mat2 m;
  m << (l(0, 0) * d - l(0, 1) * c) * inverse, (l(0, 1) * a - l(0, 0) * b) * inverse,
      (l(1, 0) * d - l(1, 1) * c) * inverse, (l(1, 1) * a - l(1, 0) * b) * inverse;
  return m;
}

}  // namespace

void update_stress(State& state, const MaterialModel& model, double dt, StepReport& report) {
  Particles& ps = state.particles;
  double lowest = 0, highest = 0, fastest = 0, overpressed = 0, overstrained = 0, kinetic = 0;
  bool finite = true;  // std::max would lose a NaN
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const Mat2& l = state.velocity_gradient[p];
    // det(1 + dt L) - 1 without the 1, so that small dilations keep their digits
    const double growth = dt * (l(0, 0) + l(1, 1)) + dt * dt * (l(0, 0) * l(1, 1) - l(0, 1) * l(1, 0));
    ps.dilation[p] = MieGrueneisen::expanded(ps.dilation[p] + (1 + ps.dilation[p]) * growth);
    const MieGrueneisen::Volume volume(ps.dilation[p]);
    const double density = model.eos.rho0 * (1 + volume.mu);
    const double specific_volume = model.eos.inverse_rho0 * (1 + volume.dilation);

    const Mat2 middle = at_middle(l, dt);
    const PlaneTensor rate = symmetric(middle);
    const double theta = rate.xx + rate.yy;
    const Rotation rotation = Rotation::of_spin(0.5 * dt * (middle(1, 0) - middle(0, 1)));
    PlaneTensor* back_stress = ps.back_stress.empty() ? nullptr : &ps.back_stress[p];
    const double plastic_work = model.strength.update(dt * deviator(rate), rotation, ps.deviator[p],
                                                      back_stress, ps.plastic_strain[p]);
    ps.plastic_work[p] += plastic_work * specific_volume;

    // The pressure of the last step is near enough for the sound speed of viscosity and time step.
    const double bulk_square = model.eos.sound_speed_squared(volume, ps.pressure[p]);
    const double bulk_sound = std::sqrt(bulk_square);
    const double q = model.viscosity.pressure(density, theta, bulk_sound);
    const MieGrueneisen::Line line = model.eos.line(volume);
    const double half = 0.5 * dt * specific_volume;
    const double energy = ps.energy[p] + half * (contract(ps.deviator[p], rate) - q * theta);
    ps.pressure[p] = model.eos.held((line.cold + line.thermal * energy) / (1 + line.thermal * half * theta));
    ps.viscous_pressure[p] = q;

    const double longitudinal = bulk_square + 4.0 / 3.0 * model.strength.shear_modulus * specific_volume;
    const double viscous = model.viscosity.speed(theta, bulk_sound);
    const double speed = ps.velocity[p].cwiseAbs().maxCoeff();
    const double signal = speed + viscous + std::sqrt(viscous * viscous + longitudinal);
    finite &= std::isfinite(signal) && std::isfinite(ps.pressure[p]) && std::isfinite(ps.energy[p]);
    fastest = std::max(fastest, signal);
    if (ps.pressure[p] > model.eos.pressure_limit) overpressed += ps.mass[p];
    if (!MieGrueneisen::holds_at(volume.dilation)) overstrained += ps.mass[p];
    kinetic += ps.kinetic_energy(p);
    lowest = std::min(lowest, volume.dilation);
    highest = std::max(highest, volume.dilation);
  }
  report.largest_signal = finite ? fastest : std::numeric_limits<double>::quiet_NaN();
  report.overpressed_mass = overpressed;
  report.overstrained_mass = overstrained;
  report.kinetic_energy = kinetic;
  report.smallest_dilation = lowest;
  report.largest_dilation = highest;
}

}  // namespace mpm
