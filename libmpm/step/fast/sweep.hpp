#pragma once
/// The one pass over the particles of a step: grid to particles, stress, particles to the grid of the next
/// step. p2g needs no time step, so it can follow while the particle is at hand; walls and time step come in
/// between, on the grid. A chunk of particles goes through four loops that stay in the first-level cache:
///   1. weights      packs of particles side by side
///   2. gather       one particle at a time, the components of a node side by side (transfer.hpp)
///   3. update       packs: motion, energy, stress, new weights, what the grid will receive
///   4. scatter      one particle at a time, in the order of storage
#include "libmpm/step/fast/constitutive.hpp"
#include "libmpm/step/fast/transfer.hpp"

namespace mpm::fast::MPM_ISA {

/// Blocks a chunk: its buffers take 344 bytes a particle (double).
inline constexpr int chunk_blocks = 8;

template <class Real, bool gimp_shape, bool back_stress_used, bool linear_tension>
struct Sweep {
  using P = Pack<Real>;
  static constexpr int width = Lanes<Real>::width;
  static constexpr Variant variant{gimp_shape, back_stress_used, linear_tension};
  static constexpr int columns = common_columns + (gimp_shape ? 2 : 0) + (back_stress_used ? 3 : 0);
  static constexpr int half_size = common_columns;
  static constexpr int back_stress = common_columns + (gimp_shape ? 2 : 0);

  struct Chunk {
    PackWeights<Real> weights[chunk_blocks];
    Seen<Real> seen[chunk_blocks * width];
    Given<Real> given[chunk_blocks * width];
    P mass_y[chunk_blocks][3];
    Gradient<Real> gradient[chunk_blocks];
    Strain<Real> strain[chunk_blocks];
  };

  static MPM_INLINE Bounds<Real> bounds(const Nodes<Real>& n) {
    return {all<Real>(-0.5), all<Real>(n.columns + 0.5), all<Real>(n.rows - 3.0)};
  }
  static MPM_INLINE auto weigh_block(const P* f, const Bounds<Real>& bounds, Real stride,
                                     PackWeights<Real>& w) {
    if constexpr (gimp_shape)
      return weigh<Real, true>(f[position_x], f[position_y], f[half_size], f[half_size + 1], bounds, stride,
                               w);
    else
      return weigh<Real, false>(f[position_x], f[position_y], P{}, P{}, bounds, stride, w);
  }

  /// What the block gives to the grid.
  static MPM_INLINE void give(const P* f, const Constants<Real>& k, const PackWeights<Real>& w,
                              Given<Real>* given, P* mass_y) {
    const P mass = f[initial_volume], volume = mass * (1 + f[Column::dilation]);
    const P mean = f[Column::pressure] + f[viscous_pressure];
    const P per_x = volume * k.force_x, per_y = volume * k.force_y;
    const P xx = (mean - f[deviator_xx]) * per_x, yy = (mean - f[deviator_yy]) * per_y;
    const P xy_x = -f[deviator_xy] * per_x, xy_y = -f[deviator_xy] * per_y;
    auto* rows = reinterpret_cast<Quad<Real>*>(given);
    transpose_out(mass * f[velocity_x], mass * f[velocity_y], xy_y, yy, rows, 3);
    transpose_out(P{}, P{}, xx, xy_x, rows + 1, 3);
    transpose_out(w.x[0], w.x[1], w.x[2], P{}, rows + 2, 3);
    for (int j = 0; j < 3; ++j) mass_y[j] = mass * w.y[j];
  }

  /// Motion and energy of a block from what it sees; the gradient of its displacement.
  static MPM_INLINE Gradient<Real> advance(P* f, const Seen<Real>* seen, const PackWeights<Real>& w,
                                           const Constants<Real>& k, Real dt, Extremes<Real>& extremes,
                                           P* sums) {
    const auto* rows = reinterpret_cast<const Quad<Real>*>(seen);
    P vx, vy, dvx, dvy, vx_x, vy_x, dvx_x, dvy_x, vx_y, vy_y, dvx_y, dvy_y, s0, s1, s2, foreign;
    transpose_in(rows, 4, vx, vy, dvx, dvy);
    transpose_in(rows + 1, 4, vx_x, vy_x, dvx_x, dvy_x);
    transpose_in(rows + 2, 4, vx_y, vy_y, dvx_y, dvy_y);
    transpose_in(rows + 3, 4, s0, s1, s2, foreign);
    const Real to_x = dt * k.inverse_cell_x, to_y = dt * k.inverse_cell_y;
    const Gradient<Real> l{to_x * vx_x, to_y * vx_y, to_x * vy_x, to_y * vy_y};

    // work of the stress that made the forces, on the velocity in the middle of the step
    const Real half = 0.5;
    const P mean = f[Column::pressure] + f[viscous_pressure];
    const P middle_xx = to_x * (vx_x - half * dvx_x), middle_yy = to_y * (vy_y - half * dvy_y);
    const P middle_xy = to_y * (vx_y - half * dvx_y) + to_x * (vy_x - half * dvy_x);
    const P power = (f[deviator_xx] - mean) * middle_xx + (f[deviator_yy] - mean) * middle_yy +
                    f[deviator_xy] * middle_xy;
    const P work = (k.inverse_rho0 * (1 + f[Column::dilation])) * power;
    const P square = s1 + (w.x[0] * (s0 - s1) + w.x[2] * (s2 - s1));
    const P heat = half * (square - (dvx * dvx + dvy * dvy));
    f[energy] += work + heat;
    sums[0] += f[initial_volume] * heat;
    sums[1] += f[initial_volume] * dvx;
    sums[2] += f[initial_volume] * dvy;

    f[velocity_x] += dvx;
    f[velocity_y] += dvy;
    f[position_x] += to_x * vx;
    f[position_y] += to_y * vy;
    extremes.low = smaller(extremes.low, f[position_y]);
    extremes.high = larger(extremes.high, f[position_y]);
    if constexpr (gimp_shape) {
      f[half_size] *= 1 + l.xx;
      f[half_size + 1] *= 1 + l.yy;
    }
    return l;
  }

  static MPM_INLINE void scatter_chunk(const Chunk& chunk, int blocks, Nodes<Real> to) {
    for (int b = 0; b < blocks; ++b)
#pragma GCC unroll 4
      for (int lane = 0; lane < width; ++lane)
        MPM_ISA::scatter(to, chunk.weights[b], lane, chunk.given[b * width + lane], chunk.mass_y[b]);
  }

  static void scatter(const Real* blocks, std::size_t block_count, const Nodes<Real>& to,
                      const Constants<Real>& k) {
    const Bounds<Real> inside = bounds(to);
    Chunk chunk;
    for (std::size_t start = 0; start < block_count; start += chunk_blocks) {
      const int count =
          static_cast<int>(block_count - start < chunk_blocks ? block_count - start : chunk_blocks);
      const auto* f = reinterpret_cast<const P*>(blocks) + start * columns;
      for (int b = 0; b < count; ++b) {
        weigh_block(f + b * columns, inside, to.stride, chunk.weights[b]);
        give(f + b * columns, k, chunk.weights[b], chunk.given + b * width, chunk.mass_y[b]);
      }
      scatter_chunk(chunk, count, to);
    }
  }

  /// Asks for a block before it is needed. Behind the last one this does no harm.
  static MPM_INLINE void prefetch(const P* block) {
    for (int c = 0; c < columns; c += 64 / static_cast<int>(sizeof(P))) __builtin_prefetch(block + c, 1);
  }

  static void sweep(Real* blocks, std::size_t block_count, const Nodes<Real>& from_nodes,
                    const Nodes<Real>& to_nodes, const Constants<Real>& constants, double time_step,
                    SweepReport& report) {
    const Nodes<Real> from = from_nodes, to = to_nodes;
    const Constants<Real> k = constants;
    const Bounds<Real> inside = bounds(from), inside_next = bounds(to);
    const Real dt = static_cast<Real>(time_step), inverse_dt = static_cast<Real>(1 / time_step);
    Extremes<Real> extremes;
    extremes.low = reinterpret_cast<const P*>(blocks)[position_y];
    extremes.high = extremes.low;
    double totals[3] = {};
    Chunk chunk;
    for (std::size_t start = 0; start < block_count; start += chunk_blocks) {
      const int count =
          static_cast<int>(block_count - start < chunk_blocks ? block_count - start : chunk_blocks);
      auto* f = reinterpret_cast<P*>(blocks) + start * columns;
      for (int b = 0; b < count; ++b) weigh_block(f + b * columns, inside, from.stride, chunk.weights[b]);
      for (int b = 0; b < count; ++b) {
        prefetch(f + (chunk_blocks + b) * columns);
#pragma GCC unroll 4
        for (int lane = 0; lane < width; ++lane)
          chunk.seen[b * width + lane] = gather(from, chunk.weights[b], lane);
      }
      P sums[3] = {};
      for (int b = 0; b < count; ++b)
        chunk.gradient[b] =
            advance(f + b * columns, chunk.seen + b * width, chunk.weights[b], k, dt, extremes, sums);
      for (int b = 0; b < count; ++b)
        chunk.strain[b] = strain_of<Real, linear_tension>(f + b * columns, chunk.gradient[b], k);
      for (int b = 0; b < count; ++b)
        update_deviator<Real, back_stress_used>(f + b * columns, f + b * columns + back_stress,
                                                chunk.strain[b], k);
      for (int b = 0; b < count; ++b)
        update_pressure<Real, linear_tension>(f + b * columns, chunk.strain[b], k, inverse_dt, extremes);
      for (int b = 0; b < count; ++b)
        extremes.broken |= weigh_block(f + b * columns, inside_next, to.stride, chunk.weights[b]);
      for (int b = 0; b < count; ++b)
        give(f + b * columns, k, chunk.weights[b], chunk.given + b * width, chunk.mass_y[b]);
      for (int n = 0; n < 3; ++n)
        for (int lane = 0; lane < width; ++lane) totals[n] += static_cast<double>(sums[n][lane]);
      scatter_chunk(chunk, count, to);
    }
    report.transfer_heat += totals[0];
    report.momentum_x += totals[1];
    report.momentum_y += totals[2];
    for (int lane = 0; lane < width; ++lane) {
      const auto raise = [](double& most, double v) { most = v > most ? v : most; };
      const auto lower = [](double& least, double v) { least = v < least ? v : least; };
      raise(report.largest_signal, extremes.signal[lane]);
      raise(report.largest_dilation, extremes.high_dilation[lane]);
      report.overpressed += extremes.overpressed[lane];
      raise(report.highest, extremes.high[lane]);
      lower(report.lowest, extremes.low[lane]);
      lower(report.smallest_dilation, extremes.low_dilation[lane]);
      report.broken |= extremes.broken[lane] != 0;
    }
  }
};

}  // namespace mpm::fast::MPM_ISA
