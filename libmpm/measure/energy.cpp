#include "libmpm/measure/energy.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "energy_error",
     .unit = "1",
     .meaning = "largest relative error of kinetic + internal energy; also a column of `jobs`",
     .has_interval = false,
     .lower = 0,
     .column = true},
    {.name = "momentum_error",
     .unit = "1",
     .meaning =
         "largest error of momentum against the impulse of the wall, relative to the momentum at impact",
     .has_interval = false,
     .lower = 0},
    {.name = "transfer_heat_fraction",
     .unit = "1",
     .meaning = "share of the initial energy that the transfer between grid and particles turned into heat",
     .lower = 0},
    {.name = "final_kinetic_fraction",
     .unit = "1",
     .meaning = "kinetic energy at the end / initial energy",
     .lower = 0},
    {.name = "overpressed_mass_fraction",
     .unit = "1",
     .meaning = "largest share of the mass that was beyond `pressure_limit` at one time",
     .has_interval = false,
     .lower = 0,
     .upper = 1},
};

}  // namespace

template <int axes>
std::span<const ResultRow> BasicBalance<axes>::results() {
  return rows;
}

template <int axes>
Energy energy_of(const BasicParticles<axes>& ps) {
  return energy_of(ps, {0, ps.size()});
}

template <int axes>
Energy energy_of(const BasicParticles<axes>& ps,
                 const std::type_identity_t<typename BasicParticles<axes>::Range>& range) {
  Energy e;
  for (std::size_t p = range.first; p < range.last; ++p) {
    e.kinetic += ps.kinetic_energy(p);
    e.internal += ps.mass[p] * ps.energy[p];
  }
  return e;
}

template <int axes>
Vec<axes> momentum_of(const BasicParticles<axes>& ps) {
  Vec<axes> sum = Vec<axes>::Zero();
  for (std::size_t p = 0; p < ps.size(); ++p) sum += ps.mass[p] * ps.velocity[p];
  return sum;
}

template <int axes>
BasicBalance<axes>::BasicBalance(const State& s)
    : initial_energy_(energy_of(s.particles).total()),
      initial_momentum_(momentum_of(s.particles)),
      momentum_scale_(0),
      loads_(Loads::of(s)) {
  const auto& ps = s.particles;
  for (std::size_t p = 0; p < ps.size(); ++p) momentum_scale_ += ps.mass[p] * ps.velocity[p].norm();
}

template <int axes>
void BasicBalance<axes>::after_step(const State&, const StepReport& report, double) {
  impulse_ += report.wall_impulse + report.gravity_impulse + report.rigid_impulse;
  loads_.add(report);
  transfer_heat_ += report.transfer_heat;
  overpressed_mass_ = std::max(overpressed_mass_, report.overpressed_mass);
}

template <int axes>
void BasicBalance<axes>::sample(const State& s, Observer&) {
  look_at(s);
}

template <int axes>
void BasicBalance<axes>::look_at(const State& s) {
  // a body at rest has neither: nothing off is no error
  const auto relative = [](double off, double scale) { return off == 0 ? 0 : off / scale; };
  const double energy =
      relative(std::abs(energy_of(s.particles).total() - initial_energy_ - loads_.work), energy_scale());
  const double momentum = relative((momentum_of(s.particles) - initial_momentum_ - impulse_).norm(),
                                   momentum_scale_ + loads_.gross_impulse);
  // written so that a NaN stays
  if (!(energy <= energy_error_)) energy_error_ = energy;
  if (!(momentum <= momentum_error_)) momentum_error_ = momentum;
}

template <int axes>
void BasicBalance<axes>::finish(const State& s, RunResult& result) const {
  BasicBalance now = *this;
  now.look_at(s);
  result.energy_error = now.energy_error_;
  result.metrics.push_back(metric(row_of(rows, "energy_error"), now.energy_error_));
  result.metrics.push_back(metric(row_of(rows, "momentum_error"), now.momentum_error_));
  result.metrics.push_back(metric(row_of(rows, "transfer_heat_fraction"), transfer_heat_ / energy_scale()));
  result.metrics.push_back(
      metric(row_of(rows, "final_kinetic_fraction"), energy_of(s.particles).kinetic / energy_scale()));
  double mass = 0;
  for (const double m : s.particles.mass) mass += m;
  result.metrics.push_back(metric(row_of(rows, "overpressed_mass_fraction"), overpressed_mass_ / mass));
}

template <int axes>
void BasicBalance<axes>::carry(Archive& a) {
  a.number("impulse", impulse_), a.number("transfer_heat", transfer_heat_);
  a.number("energy_error", energy_error_), a.number("momentum_error", momentum_error_);
  a.number("overpressed_mass", overpressed_mass_);
  loads_.carry(a);
}

template Energy energy_of(const Particles&);
template Energy energy_of(const BasicParticles<3>&);
template Energy energy_of(const Particles&, const Particles::Range&);
template Energy energy_of(const BasicParticles<3>&, const BasicParticles<3>::Range&);
template Vec2 momentum_of(const Particles&);
template Vec3 momentum_of(const BasicParticles<3>&);
template class BasicBalance<2>;
template class BasicBalance<3>;

}  // namespace mpm
