#include "libmpm/step/fast/fast_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mpm::fast {
namespace {

/// A particle moves a few hundredths of a cell in a step, and most of that together with its neighbours.
/// Measured: PERFORMANCE.md.
constexpr int steps_between_sorts = 100;

Constants<double> constants_of(const MaterialModel& m, const Grid& grid) {
  const MieGrueneisen& eos = m.eos;
  Constants<double> k{};
  k.rho0 = eos.rho0;
  k.inverse_rho0 = eos.inverse_rho0;
  k.cold_c = eos.c, k.cold_d = eos.d, k.cold_s = eos.s;
  k.gamma0 = eos.gamma0;
  k.least_sound_square = 0.1 * eos.c * eos.inverse_rho0;
  k.pressure_floor =
      eos.tension == Tension::cutoff ? -eos.spall_strength : -std::numeric_limits<double>::infinity();
  k.pressure_limit = eos.pressure_limit;
  k.shear_modulus = m.strength.shear_modulus;
  k.yield_stress = m.strength.yield_stress;
  k.isotropic_modulus = m.strength.isotropic_modulus;
  k.kinematic_modulus = m.strength.kinematic_modulus;
  k.inverse_return = 1 / (3 * k.shear_modulus + k.isotropic_modulus + k.kinematic_modulus);
  k.linear_viscosity = m.viscosity.linear;
  k.quadratic_viscosity = m.viscosity.quadratic;
  k.viscous_length = m.viscosity.length;
  k.inverse_cell_x = grid.inverse_cell().x();
  k.inverse_cell_y = grid.inverse_cell().y();
  k.force_x = k.inverse_rho0 * k.inverse_cell_x;
  k.force_y = k.inverse_rho0 * k.inverse_cell_y;
  return k;
}

}  // namespace

FastStepper::FastStepper(const MaterialModel& model, const Variant& variant)
    : FastStepper(model, variant, kernels_for(variant)) {}

FastStepper::FastStepper(const MaterialModel& model, const Variant& variant, const Kernels<double>& kernels)
    : model_(model), variant_(variant), kernels_(kernels) {}

/// The particles' first way to the grid.
void FastStepper::begin(State& state) {
  const Grid& grid = state.grid;
  constants_ = constants_of(model_, grid);
  blocks_.emplace(state.particles, grid, variant_, model_.eos.rho0);
  now_.emplace(grid.columns());
  next_.emplace(grid.columns());
  state.velocity_gradient = {};
  lowest_ = std::numeric_limits<double>::infinity(), highest_ = 0;
  for (const Vec2& x : state.particles.position) {
    const double y = (x.y() - grid.origin().y()) * grid.inverse_cell().y();
    lowest_ = std::min(lowest_, y), highest_ = std::max(highest_, y);
  }
  next_->prepare(highest_);
  blocks_->sort(next_->nodes().stride);
  kernels_.scatter(blocks_->data(), blocks_->count(), next_->nodes(), constants_);
  next_->use(lowest_, highest_);
}

StepReport FastStepper::step(State& state, double dt) {
  if (!blocks_) begin(state);
  std::swap(now_, next_);
  now_->reflect_sides();
  if (state.floor == Floor::mirror) now_->reflect_floor();
  kernels_.move(now_->nodes(), now_->first_row(), now_->last_row(), dt);
  if (state.floor == Floor::impact_wall) now_->push_off_wall();
  if (++since_sort_ >= steps_between_sorts) {
    blocks_->sort(now_->nodes().stride);
    since_sort_ = 0;
  }
  next_->prepare(highest_);
  SweepReport sums{};
  sums.lowest = std::numeric_limits<double>::infinity();
  kernels_.sweep(blocks_->data(), blocks_->count(), now_->nodes(), next_->nodes(), constants_, dt, sums);
  lowest_ = sums.lowest, highest_ = sums.highest;
  next_->use(lowest_, highest_);

  const Grid& grid = state.grid;
  const double unit = model_.eos.rho0 * grid.cell().x() * grid.cell().y();
  StepReport report;
  report.largest_signal = sums.broken ? std::numeric_limits<double>::quiet_NaN() : sums.largest_signal;
  report.smallest_dilation = sums.smallest_dilation;
  report.largest_dilation = sums.largest_dilation;
  report.overpressed_mass = unit * sums.overpressed;
  report.transfer_heat = unit * sums.transfer_heat;
  report.wall_impulse = unit * Vec2(sums.momentum_x, sums.momentum_y);
  report.highest = grid.origin().y() + highest_ * grid.cell().y();
  state.time += dt;
  ++state.step;
  return report;
}

void FastStepper::refresh_particles(State& state) {
  if (blocks_) blocks_->copy_to(state.particles, state.grid);
}

void FastStepper::refresh_particles(State& state, std::span<const std::size_t> which) {
  if (blocks_) blocks_->copy_to(state.particles, state.grid, which);
}

void FastStepper::refresh_nodes(State& state, int first_row, int last_row) {
  if (now_) now_->copy_rows(state.grid, model_.eos.rho0, first_row, last_row);
}

std::size_t FastStepper::memory() const {
  return blocks_ ? blocks_->memory() + now_->memory() + next_->memory() : 0;
}

}  // namespace mpm::fast
