#include "libmpm/step/fast/fast_stepper.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "libmpm/material/list.hpp"

namespace mpm::fast {
namespace {

using Clock = std::chrono::steady_clock;

/// A sort costs as much as so many sweeps over blocks out of step cost more than over blocks in step, as a
/// share of all blocks, whatever the number of their strays. When blocks out of step have cost that much, it
/// is time to sort. Measured: PERFORMANCE.md.
constexpr double sort_cost = 1;

/// Of the grid, that a thread takes at a time.
template <int axes>
constexpr int rows_of_part = axes == 3 ? 2 : 32;

/// A thread that is given fewer costs more than it brings: PERFORMANCE.md.
constexpr std::size_t least_particles = 10000;

/// Rows beyond those of its band where a stencil may start. Bands of the same parity then never meet.
constexpr int band_reach = 2;

template <class Real, int axes>
Constants<Real, axes> constants_of(double density, const BasicGrid<axes>& grid) {
  const double inverse_rho0 = 1 / density;
  const auto real = [](double v) { return static_cast<Real>(v); };
  Constants<Real, axes> k{};
  k.inverse_rho0 = real(inverse_rho0);
  for (int a = 0; a < axes; ++a) {
    k.inverse_cell[a] = real(grid.inverse_cell()[a]);
    k.force[a] = real(inverse_rho0 * grid.inverse_cell()[a]);
  }
  return k;
}

}  // namespace

template <class Real, int axes>
FastStepper<Real, axes>::FastStepper(const MaterialModels& materials, Shape shape, Space space,
                                     InstructionSet set)
    : space_(space), density_(materials.of.at(0).material.reference_density), stocks_(materials.of.size()) {
  const bool gimp = shape == Shape::gimp;
  for (std::size_t m = 0; m < stocks_.size(); ++m)
    with_model<Real>(materials.of[m], [&](const auto& model, std::size_t place) {
      Stock& stock = stocks_[m];
      static_assert(std::is_trivially_copyable_v<std::decay_t<decltype(model)>> &&
                    sizeof model <= sizeof stock.model);
      std::memcpy(stock.model.data(), &model, sizeof model);
      stock.density = materials.of[m].material.reference_density;
      stock.own = model.state;
      stock.layout = {gimp, space, numbers_in(stock.own, axes)};
      stock.kernels = kernels_for<Real, axes>(gimp, space, place, set);
    });
}

/// The particles' first way to the grid.
template <class Real, int axes>
void FastStepper<Real, axes>::begin(State& state) {
  const BasicGrid<axes>& grid = state.grid;
  BasicParticles<axes>& ps = state.particles;
  grid_.emplace(grid);
  for (std::size_t m = 0; m < stocks_.size(); ++m) {
    Stock& stock = stocks_[m];
    ps.keep(stock.own);
    stock.constants = constants_of<Real>(stock.density, grid);
    stock.blocks.emplace(ps, ps.range_of(m), stock.own, grid, stock.layout, density_, grid_->nodes());
  }
  state.velocity_gradient = {};
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const Vec<axes>& x : ps.position) {
    const double row = std::floor((x.y() - grid.origin().y()) * grid.inverse_cell().y() + 0.5);
    lowest = std::min(lowest, row), highest = std::max(highest, row);
  }
  const std::int64_t to_row = grid_->nodes().to_row;
  use(static_cast<std::int64_t>(lowest) * to_row, static_cast<std::int64_t>(highest) * to_row);
  for (Stock& stock : stocks_) {
    stock.blocks->sort(grid_->nodes().rows);
    for (const auto& range : stock.blocks->bands())
      stock.kernels.transfers.scatter(band(stock, range), grid_->nodes(), stock.constants);
  }
}

/// Says where the particles are now.
template <class Real, int axes>
void FastStepper<Real, axes>::use(std::int64_t lowest_node, std::int64_t highest_node) {
  const int to_row = grid_->nodes().to_row, highest = static_cast<int>(highest_node / to_row);
  const int lowest = static_cast<int>(lowest_node / to_row) - 1;
  first_row_ = lowest > 1 ? lowest : -1;  // the floor acts on rows -1, 0 and 1
  last_row_ = highest + 1;
  grid_->reach(highest);
}

template <class Real, int axes>
Band<Real> FastStepper<Real, axes>::band(Stock& stock, const typename Blocks::Range& range) {
  return {stock.blocks->block(range.first), range.count, stock.layout.columns(),
          std::max(range.first_row - band_reach, 0),
          std::min(range.last_row + band_reach, grid_->nodes().rows - 3)};
}

template <class Real, int axes>
std::size_t FastStepper<Real, axes>::blocks() const {
  std::size_t sum = 0;
  for (const Stock& stock : stocks_) sum += stock.blocks->count();
  return sum;
}

template <class Real, int axes>
SweepReport FastStepper<Real, axes>::sweep(double dt) {
  SweepReport sums{};
  sums.lowest_node = std::numeric_limits<std::int64_t>::max();
  leaving_band_ = false;
  for (Stock& stock : stocks_) sweep(stock, dt, sums);
  return sums;
}

/// Bands of the same parity touch different nodes, so that any thread may take any of them; the odd ones
/// follow the even ones.
template <class Real, int axes>
void FastStepper<Real, axes>::sweep(Stock& stock, double dt, SweepReport& sums) {
  const auto bands = stock.blocks->bands();
  reports_.assign(bands.size(), {});
  StressUpdate<Real, axes> stress = stock.kernels.stress;
  stress.model = stock.model.data();
  for (const std::size_t parity : {0, 1})
    team_.run((bands.size() + 1 - parity) / 2, [&, parity](std::size_t k) {
      SweepReport& own = reports_[2 * k + parity];
      own.lowest_node = std::numeric_limits<std::int64_t>::max();
      stock.kernels.transfers.sweep(band(stock, bands[2 * k + parity]), grid_->nodes(), stock.constants, dt,
                                    stress, own);
    });

  const std::int64_t to_row = grid_->nodes().to_row;
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const SweepReport& own = reports_[b];
    sums.largest_signal = std::max(sums.largest_signal, own.largest_signal);
    sums.smallest_dilation = std::min(sums.smallest_dilation, own.smallest_dilation);
    sums.largest_dilation = std::max(sums.largest_dilation, own.largest_dilation);
    sums.overpressed += own.overpressed;
    sums.overstrained += own.overstrained;
    sums.kinetic += own.kinetic;
    sums.lowest_node = std::min(sums.lowest_node, own.lowest_node);
    sums.highest_node = std::max(sums.highest_node, own.highest_node);
    sums.transfer_heat += own.transfer_heat;
    for (int a = 0; a < axes; ++a) sums.momentum[a] += own.momentum[a];
    sums.out_of_step += own.out_of_step;
    sums.broken |= own.broken;
    leaving_band_ |= own.lowest_node < (bands[b].first_row - 1) * to_row ||
                     own.highest_node >= (bands[b].last_row + 2) * to_row;
  }
}

/// What the particles gave to the nodes becomes motion. Rows do not ask for each other.
template <class Real, int axes>
bool FastStepper<Real, axes>::move(State& state, double dt) {
  const Floor floor = state.floor;
  const Nodes<Real, axes>& nodes = grid_->nodes();
  const auto each_row = [&](auto&& work) {
    const int rows = last_row_ - first_row_ + 1, parts = (rows + rows_of_part<axes> - 1) / rows_of_part<axes>;
    team_.run(static_cast<std::size_t>(parts), [&](std::size_t k) {
      const int first = first_row_ + static_cast<int>(k) * rows_of_part<axes>;
      work(first, std::min(first + rows_of_part<axes> - 1, last_row_));
    });
  };
  each_row([&](int first, int last) {
    stocks_[0].kernels.transfers.collect(nodes, first, last);
    grid_->reflect_sides(first, last);
  });
  const bool at_open_face = grid_->at_open_face(state.open, floor, first_row_, last_row_);
  if (floor == Floor::mirror && first_row_ == -1) grid_->reflect_floor();
  each_row([&](int first, int last) { stocks_[0].kernels.transfers.move(nodes, first, last, dt); });
  if (floor == Floor::impact_wall && first_row_ == -1)
    grid_->push_off_wall(state.tracks_wall_gap ? &state.wall_gaps : nullptr, dt);
  moved_first_ = first_row_, moved_last_ = last_row_;
  return at_open_face;
}

template <class Real, int axes>
BasicStepReport<axes> FastStepper<Real, axes>::step(State& state, double dt) {
  if (!grid_) begin(state);
  auto now = Clock::now();
  const auto spent = [&now](double& on) {
    const auto then = std::exchange(now, Clock::now());
    on += std::chrono::duration<double>(now - then).count();
  };
  const bool at_open_face = move(state, dt);
  spent(times_.grid);
  if (leaving_band_ || static_cast<double>(out_of_step_) > sort_cost * static_cast<double>(blocks())) {
    for (Stock& stock : stocks_) stock.blocks->sort(grid_->nodes().rows);
    out_of_step_ = 0;
  }
  spent(times_.sort);
  const SweepReport sums = sweep(dt);
  spent(times_.particles);
  out_of_step_ += sums.out_of_step;
  for (const Stock& stock : stocks_) out_of_step_ -= static_cast<std::int64_t>(stock.blocks->loose());
  use(sums.lowest_node, sums.highest_node);

  const BasicGrid<axes>& grid = state.grid;
  const double unit = unit_mass(density_, grid, space_);
  BasicStepReport<axes> report;
  report.largest_signal = sums.broken ? std::numeric_limits<double>::quiet_NaN() : sums.largest_signal;
  report.smallest_dilation = sums.smallest_dilation;
  report.largest_dilation = sums.largest_dilation;
  report.overpressed_mass = unit * sums.overpressed;
  report.overstrained_mass = unit * sums.overstrained;
  report.kinetic_energy = unit * sums.kinetic;
  report.transfer_heat = unit * sums.transfer_heat;
  report.at_open_face = at_open_face;
  for (int a = 0; a < axes; ++a) report.wall_impulse[a] = unit * sums.momentum[a];
  state.time += dt;
  ++state.step;
  return report;
}

template <class Real, int axes>
void FastStepper<Real, axes>::use_threads(int threads) {
  const std::size_t particles = grid_ ? blocks() * Blocks::width : 0;
  const auto most = static_cast<int>(std::max<std::size_t>(particles / least_particles, 1));
  team_.resize(std::min(threads, most));
}

template <class Real, int axes>
void FastStepper<Real, axes>::refresh_particles(State& state) {
  if (!grid_) return;
  for (Stock& stock : stocks_) stock.blocks->copy_to(state.particles, state.grid);
}

template <class Real, int axes>
void FastStepper<Real, axes>::refresh_particles(State& state, std::span<const std::size_t> which) {
  if (!grid_) return;
  for (Stock& stock : stocks_) stock.blocks->copy_to(state.particles, state.grid, which);
}

template <class Real, int axes>
void FastStepper<Real, axes>::refresh_nodes(State& state, int first_row, int last_row) {
  if (!grid_) return;
  const double unit = unit_mass(density_, state.grid, space_);
  grid_->copy_rows(state.grid, unit, first_row, last_row, moved_first_, moved_last_);
}

template <class Real, int axes>
std::size_t FastStepper<Real, axes>::memory() const {
  if (!grid_) return 0;
  std::size_t sum = grid_->memory();
  for (const Stock& stock : stocks_) sum += stock.blocks->memory();
  return sum;
}

/// The blocks hold the particles, the nodes their sums for the next step: the State's particles are not
/// needed.
template <class Real, int axes>
void FastStepper<Real, axes>::carry(State& state, Archive& a) {
  if (!grid_) begin(state);
  for (std::size_t m = 0; m < stocks_.size(); ++m) {
    Archive blocks = a.part(m == 0 ? "blocks" : "blocks-" + std::to_string(m));
    stocks_[m].blocks->carry(blocks);
  }
  Archive nodes = a.part("nodes");
  grid_->carry(nodes);
  this->carry_wall_gaps(state, a);
  a.integer("first_row", first_row_), a.integer("last_row", last_row_);
  a.integer("moved_first", moved_first_), a.integer("moved_last", moved_last_);
  a.integer("out_of_step", out_of_step_), a.integer("leaving_band", leaving_band_);
}

template class FastStepper<double, 2>;
template class FastStepper<float, 2>;
template class FastStepper<double, 3>;
template class FastStepper<float, 3>;

}  // namespace mpm::fast
