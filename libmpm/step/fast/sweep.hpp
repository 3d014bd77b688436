#pragma once
/// The one pass over the particles of a step: grid to particles, stress, particles to the grid of the next
/// step. p2g needs no time step, so it can follow while the particle is at hand; walls and time step come in
/// between, on the grid. A chunk of particles goes through a few loops that stay in the first-level cache:
/// a pack's chain of operations is long in each, and the processor finds room for several packs at once.
#include "libmpm/step/fast/transfer.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real, bool gimp, class Space>
struct Sweep {
  using P = Pack<Real>;
  static constexpr int width = Lanes<Real>::width;
  static constexpr int half_size = Layout::half_size();
  static constexpr bool has_hoop = Space::has_hoop;
  static constexpr int sure_columns = Layout{gimp, Space::value, 0}.own();
  using Weights = PackWeights<Real, has_hoop>;

  struct Chunk {
    Weights weights[chunk_blocks];
    Place<Real> place[chunk_blocks];
  };

  static MPM_INLINE void weigh(const P* f, Weights& w) {
    if constexpr (gimp) {
      gimp_axis<Real>(f[position_x], f[half_size], w.x, w.slope_x);
      gimp_axis<Real>(f[position_y], f[half_size + 1], w.y, w.slope_y);
    } else {
      bspline2_axis<Real>(f[position_x], w.x, w.slope_x);
      bspline2_axis<Real>(f[position_y], w.y, w.slope_y);
    }
    if constexpr (has_hoop && gimp) gimp_hoop<Real>(f[position_x], f[half_size], w.hoop);
    if constexpr (has_hoop && !gimp) bspline2_hoop<Real>(f[position_x], w.x, f[half_size], w.hoop);
  }

  /// 1 / r [1/cells]. Lanes without a particle may lie on the axis.
  static MPM_INLINE P inverse_radius(const P* f, const Nodes<Real>& nodes) {
    const P stride = all(static_cast<Real>(nodes.stride)), inverse = 1 / stride;
    P column = f[node] - stride * rounded<Real>((f[node] + Real(0.5)) * inverse - Real(0.5));
    // where rounding has put a node at the end of a row into the next one
    column = column < 0 ? column + stride : column;
    column = column >= stride ? column - stride : column;
    return 1 / larger(column + f[position_x], all(Real(1e-6)));
  }

  /// Lanes without a particle see nothing: their state stays what it is.
  static MPM_INLINE void blind(const P* f, Weights& w) {
    const Mask<Real> present = f[initial_volume] > 0;
    for (int i = 0; i < 3; ++i) {
      w.x[i] = where<Real>(present, w.x[i]);
      w.slope_x[i] = where<Real>(present, w.slope_x[i]);
      if constexpr (has_hoop) w.hoop[i] = where<Real>(present, w.hoop[i]);
    }
  }

  /// Motion and energy of a block from what it sees, and dt L, the gradient of its displacement: xx, xy, yx,
  /// yy; along the hoop.
  template <Order order>
  static MPM_INLINE void advance(P* f, const Nodes<Real>& nodes, const Place<Real>& place, const Weights& w,
                                 const Constants<Real>& k, Real dt, P* sums, P* gradient,
                                 [[maybe_unused]] P* hoop) {
    const Reader<Real, order> reader(nodes, f[node], place);
    const Seen<Real> vx = see(reader, motion_x, w), dvx = see(reader, change_x, w);
    const Seen<Real> vy = see(reader, motion_y, w), dvy = see(reader, change_y, w);
    const Real to_x = dt * k.inverse_cell_x, to_y = dt * k.inverse_cell_y;
    const P xx = to_x * vx.along_x, xy = to_y * vx.along_y, yx = to_x * vy.along_x, yy = to_y * vy.along_y;
    gradient[0] = xx, gradient[1] = xy, gradient[2] = yx, gradient[3] = yy;

    // work of the stress that made the forces, on the velocity in the middle of the step
    const Real half = 0.5;
    const P mean = f[Column::pressure] + f[viscous_pressure];
    const P middle_xx = xx - (half * to_x) * dvx.along_x, middle_yy = yy - (half * to_y) * dvy.along_y;
    const P middle_xy = (xy + yx) - ((half * to_y) * dvx.along_y + (half * to_x) * dvy.along_x);
    P power = (f[deviator_xx] - mean) * middle_xx + (f[deviator_yy] - mean) * middle_yy +
              f[deviator_xy] * middle_xy;
    if constexpr (has_hoop) {
      const P per_radius = to_x * inverse_radius(f, nodes);
      *hoop = per_radius * vx.hoop;
      power -= (f[deviator_xx] + f[deviator_yy] + mean) * (per_radius * (vx.hoop - half * dvx.hoop));
    }
    const P work = (k.inverse_rho0 * (1 + f[Column::dilation])) * power;
    const P square = see(reader, change_square, w).value;
    const P heat = half * (square - (dvx.value * dvx.value + dvy.value * dvy.value));
    f[energy] += work + heat;
    sums[0] += f[initial_volume] * heat;
    sums[1] += f[initial_volume] * dvx.value;
    sums[2] += f[initial_volume] * dvy.value;

    f[velocity_x] += dvx.value;
    f[velocity_y] += dvy.value;
    sums[3] += f[initial_volume] * (f[velocity_x] * f[velocity_x] + f[velocity_y] * f[velocity_y]);
    f[position_x] += to_x * vx.value;
    f[position_y] += to_y * vy.value;
    if constexpr (gimp) {
      f[half_size] *= 1 + xx;
      f[half_size + 1] *= 1 + yy;
    }
  }

  /// Particles that came nearer to another node belong to it from now on. Those that leave the grid or the
  /// rows of their band stay where they were: true.
  static bool __attribute__((noinline))
  change_nodes(P* f, const Nodes<Real>& nodes, int first_row, int last_row) {
    bool broken = false;
    for (int l = 0; l < width; ++l) {
      if (f[initial_volume][l] == 0) continue;
      const Real shift_x = rounded<Real>(f[position_x])[l], shift_y = rounded<Real>(f[position_y])[l];
      const int old = static_cast<int>(f[node][l]), row = old / nodes.stride, column = old % nodes.stride;
      const Real to_column = static_cast<Real>(column) + shift_x, to_row = static_cast<Real>(row) + shift_y;
      if (to_column >= 0 && to_column <= static_cast<Real>(nodes.columns) &&
          to_row >= static_cast<Real>(first_row) && to_row <= static_cast<Real>(last_row)) {
        f[position_x][l] -= shift_x;
        f[position_y][l] -= shift_y;
        f[node][l] = static_cast<Real>(static_cast<int>(to_row) * nodes.stride + static_cast<int>(to_column));
      } else {  // or not a number
        f[position_x][l] = f[position_y][l] = 0;
        broken = true;
      }
    }
    return broken;
  }

  /// What the block gives to the grid.
  static MPM_INLINE void give(const P* f, const Nodes<Real>& nodes, const Place<Real>& place,
                              const Weights& w, const Constants<Real>& k) {
    const P mass = f[initial_volume], volume = mass * (1 + f[Column::dilation]);
    const P mean = f[Column::pressure] + f[viscous_pressure];
    const P per_x = volume * k.force_x, per_y = volume * k.force_y;
    P hoop{};
    if constexpr (has_hoop)
      hoop = (mean + f[deviator_xx] + f[deviator_yy]) * per_x * inverse_radius(f, nodes);
    const Given<Real, has_hoop> given{mass,
                                      mass * f[velocity_x],
                                      mass * f[velocity_y],
                                      (mean - f[deviator_xx]) * per_x,
                                      -f[deviator_xy] * per_x,
                                      -f[deviator_xy] * per_y,
                                      (mean - f[deviator_yy]) * per_y,
                                      hoop};
    add(nodes, f[node], place, w, given);
  }

  static void scatter(const Band<Real>& band, const Nodes<Real>& nodes, const Constants<Real>& k) {
    const auto* f = reinterpret_cast<const P*>(band.blocks);
    for (std::size_t b = 0; b < band.count; ++b, f += band.columns) {
      Weights w;
      weigh(f, w);
      give(f, nodes, place_of<Real>(f[node]), w, k);
    }
  }

  /// Asks for a block before it is needed. Behind the last one this does no harm.
  static MPM_INLINE void prefetch(const P* block, int columns) {
    constexpr int per_line = 64 / static_cast<int>(sizeof(P)), sure = sure_columns;
#pragma GCC unroll 16
    for (int c = 0; c < sure; c += per_line) __builtin_prefetch(block + c, 1);
    for (int c = (sure + per_line - 1) / per_line * per_line; c < columns; c += per_line)
      __builtin_prefetch(block + c, 1);
  }

  static void sweep(const Band<Real>& band, const Nodes<Real>& all_nodes, const Constants<Real>& constants,
                    double time_step, const StressUpdate<Real>& stress, SweepReport& report) {
    const Nodes<Real> nodes = all_nodes;
    const Constants<Real> k = constants;
    const int columns = band.columns;
    const Real dt = static_cast<Real>(time_step), inverse_dt = static_cast<Real>(1 / time_step);
    Extremes<Real> extremes;
    P low_node = reinterpret_cast<const P*>(band.blocks)[node], high_node = low_node;
    double totals[4] = {};
    bool broken = false;
    std::int64_t out_of_step = 0;
    Chunk chunk;
    Gradients<Real> gradients;
    for (std::size_t start = 0; start < band.count; start += chunk_blocks) {
      const int count =
          static_cast<int>(band.count - start < chunk_blocks ? band.count - start : chunk_blocks);
      auto* const first = reinterpret_cast<P*>(band.blocks) + start * static_cast<std::size_t>(columns);
      const auto each_block = [&](auto&& update) __attribute__((always_inline)) {
        P* f = first;
        for (int b = 0; b < count; ++b, f += columns) update(f, b);
      };
      each_block([&](P * f, int b) __attribute__((always_inline)) {
        weigh(f, chunk.weights[b]);
        blind(f, chunk.weights[b]);
        chunk.place[b] = place_of<Real>(f[node]);
      });
      P sums[4] = {};
      each_block([&](P * f, int b) __attribute__((always_inline)) {
        prefetch(f + chunk_blocks * columns, columns);
        const Place<Real>& place = chunk.place[b];
        const Weights& w = chunk.weights[b];
        auto* const gradient = reinterpret_cast<P*>(gradients.of_block[b]);
        auto* const hoop = reinterpret_cast<P*>(gradients.hoop[b]);
        if (place.in_step())
          advance<Order::in_step>(f, nodes, place, w, k, dt, sums, gradient, hoop);
        else if (place.scattered())
          advance<Order::scattered>(f, nodes, place, w, k, dt, sums, gradient, hoop);
        else
          advance<Order::with_strays>(f, nodes, place, w, k, dt, sums, gradient, hoop);
      });
      stress.update(stress.model, reinterpret_cast<Real*>(first), count, columns, sure_columns, gradients,
                    inverse_dt, extremes);
      each_block([&](P * f, int b) __attribute__((always_inline)) {
        const P shift_x = rounded<Real>(f[position_x]), shift_y = rounded<Real>(f[position_y]);
        if (__builtin_expect(any((shift_x != 0) | (shift_y != 0)), 0)) {
          broken |= change_nodes(f, nodes, band.first_row, band.last_row);
          chunk.place[b] = place_of<Real>(f[node]);
        }
        low_node = smaller(low_node, f[node]);
        high_node = larger(high_node, f[node]);
        weigh(f, chunk.weights[b]);
      });
      each_block([&](P * f, int b) __attribute__((always_inline)) {
        out_of_step += !chunk.place[b].in_step();
        give(f, nodes, chunk.place[b], chunk.weights[b], k);
      });
      for (int n = 0; n < 4; ++n)
        for (int l = 0; l < width; ++l) totals[n] += static_cast<double>(sums[n][l]);
    }
    report.transfer_heat += totals[0];
    report.momentum_x += totals[1];
    report.momentum_y += totals[2];
    report.kinetic += 0.5 * totals[3];
    report.out_of_step += out_of_step;
    report.broken |= broken;
    for (int l = 0; l < width; ++l) {
      const double low = low_node[l], high = high_node[l];
      report.lowest_node = low < report.lowest_node ? low : report.lowest_node;
      report.highest_node = high > report.highest_node ? high : report.highest_node;
    }
    stress.report(stress.model, band, extremes, report);
  }
};

}  // namespace mpm::fast::MPM_ISA
