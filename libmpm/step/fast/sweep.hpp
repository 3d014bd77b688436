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
  static constexpr int width = Lanes<Real>::width, axes = Space::axes;
  static constexpr bool has_hoop = Space::has_hoop;
  static constexpr Layout layout{gimp, Space::value, 0};
  static constexpr int half_size = layout.half_size(), sure_columns = layout.own();
  using C = Columns<axes>;
  using M = Motion<axes>;
  using Weights = PackWeights<Real, Space>;
  using Nodes = fast::Nodes<Real, axes>;
  using Constants = fast::Constants<Real, axes>;

  struct Chunk {
    Weights weights[chunk_blocks];
    Place<Real> place[chunk_blocks];
  };

  static MPM_INLINE Whole<Real> node_of(const P* f) { return (Whole<Real>)f[C::node]; }

  static MPM_INLINE void weigh(const P* f, Weights& w) {
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      if constexpr (gimp)
        gimp_axis<Real>(f[C::position + a], f[half_size + a], w.value[a], w.slope[a]);
      else
        bspline2_axis<Real>(f[C::position + a], w.value[a], w.slope[a]);
    });
    if constexpr (has_hoop && gimp) gimp_hoop<Real>(f[C::position], f[half_size], w.hoop);
    if constexpr (has_hoop && !gimp) bspline2_hoop<Real>(f[C::position], w.value[0], f[half_size], w.hoop);
  }

  /// 1 / r [1/cells]. Lanes without a particle may lie on the axis.
  static MPM_INLINE P inverse_radius(const P* f, const Nodes& nodes) {
    const Whole<Real> stride = all_whole<Real>(nodes.stride), number = node_of(f);
    const P rows = real_of(number) * (1 / all(static_cast<Real>(nodes.stride)));
    Whole<Real> column = number - stride * whole_of(rows);
    // where the row is one beside that of the node
    column = column < 0 ? column + stride : column;
    column = column >= stride ? column - stride : column;
    return 1 / larger(real_of(column) + f[C::position], all(Real(1e-6)));
  }

  /// Lanes without a particle see nothing: their state stays what it is.
  static MPM_INLINE void blind(const P* f, Weights& w) {
    const Mask<Real> present = f[C::initial_volume] > 0;
    for (int i = 0; i < 3; ++i) {
      w.value[0][i] = where<Real>(present, w.value[0][i]);
      w.slope[0][i] = where<Real>(present, w.slope[0][i]);
      if constexpr (has_hoop) w.hoop[i] = where<Real>(present, w.hoop[i]);
    }
  }

  /// s : m of the deviator, and of a tensor m whose components off the diagonal are both sides of it added.
  static MPM_INLINE P power_of(const P* f, P mean, const P (&m)[axes][axes]) {
    const P* const s = f + C::deviator;
    P power = (s[0] - mean) * m[0][0] + (s[1] - mean) * m[1][1];
    if constexpr (axes == 3) power -= (s[0] + s[1] + mean) * m[2][2];
    power += s[2] * m[0][1];
    if constexpr (axes == 3) power += s[3] * m[0][2] + s[4] * m[1][2];
    return power;
  }

  /// Motion and energy of a block from what it sees, and dt L, the gradient of its displacement, row by row;
  /// along the hoop.
  template <Order order>
  static MPM_INLINE void advance(P* f, const Nodes& nodes, const Place<Real>& place, const Weights& w,
                                 const Constants& k, Real dt, P* sums, P* gradient,
                                 [[maybe_unused]] P* hoop) {
    const Reader<Real, axes, order> reader(nodes, node_of(f), place);
    Seen<Real, axes> v[axes], dv[axes];
    Real to[axes];
    P change[axes], l[axes][axes], middle[axes][axes];
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      v[a] = see(reader, M::velocity + a, w), dv[a] = see(reader, M::change + a, w);
      to[a] = dt * k.inverse_cell[a];
      change[a] = dv[a].value;
    });
    const Real half = 0.5;
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      each<axes>([&]<int b>() __attribute__((always_inline)) {
        gradient[a * axes + b] = l[a][b] = to[b] * v[a].along[b];
      });
    });

    // work of the stress that made the forces, on the velocity in the middle of the step
    const P mean = f[C::pressure] + f[C::viscous_pressure];
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      middle[a][a] = l[a][a] - (half * to[a]) * dv[a].along[a];
      each<axes, a + 1>([&]<int b>() __attribute__((always_inline)) {
        middle[a][b] =
            (l[a][b] + l[b][a]) - ((half * to[b]) * dv[a].along[b] + (half * to[a]) * dv[b].along[a]);
      });
    });
    P power = power_of(f, mean, middle);
    if constexpr (has_hoop) {
      const P per_radius = to[0] * inverse_radius(f, nodes);
      *hoop = per_radius * v[0].hoop;
      power -= (f[C::deviator] + f[C::deviator + 1] + mean) * (per_radius * (v[0].hoop - half * dv[0].hoop));
    }
    const P work = (k.inverse_rho0 * (1 + f[C::dilation])) * power;
    const P square = see(reader, M::change_square, w).value;
    const P heat = half * (square - square_of<axes>(change));
    f[C::energy] += work + heat;
    sums[0] += f[C::initial_volume] * heat;
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      sums[1 + a] += f[C::initial_volume] * change[a];
      f[C::velocity + a] += change[a];
      f[C::position + a] += to[a] * v[a].value;
      if constexpr (gimp) f[half_size + a] *= 1 + l[a][a];
    });
    sums[1 + axes] += f[C::initial_volume] * square_of<axes>(f + C::velocity);
  }

  /// Particles that came nearer to another node belong to it from now on. Those that leave the grid or the
  /// rows of their band stay where they were: true.
  static bool __attribute__((noinline)) change_nodes(P* f, const Nodes& nodes, int first_row, int last_row) {
    bool broken = false;
    Whole<Real> number = node_of(f);
    for (int l = 0; l < width; ++l) {
      if (f[C::initial_volume][l] == 0) continue;
      const int old = static_cast<int>(number[l]), row = old / nodes.to_row, in_row = old % nodes.to_row;
      // columns, rows, slices
      const int at[3] = {in_row % nodes.stride, row, in_row / nodes.stride};
      const int low[3] = {0, first_row, 0}, high[3] = {nodes.columns, last_row, nodes.slices};
      const int to_next[3] = {1, nodes.to_row, nodes.stride};
      Real shift[axes];
      bool inside = true;
      for (int a = 0; a < axes; ++a) {
        shift[a] = rounded<Real>(f[C::position + a])[l];
        // false where it is not a number
        inside &=
            shift[a] >= static_cast<Real>(low[a] - at[a]) && shift[a] <= static_cast<Real>(high[a] - at[a]);
      }
      for (int a = 0; a < axes; ++a) {
        if (inside) {
          f[C::position + a][l] -= shift[a];
          number[l] += static_cast<int>(shift[a]) * to_next[a];
        } else {
          f[C::position + a][l] = 0;
        }
      }
      broken |= !inside;
    }
    f[C::node] = (P)number;
    return broken;
  }

  /// What the block gives to the grid.
  static MPM_INLINE void give(const P* f, const Nodes& nodes, const Place<Real>& place, const Weights& w,
                              const Constants& k) {
    const P* const s = f + C::deviator;
    const P mass = f[C::initial_volume], volume = mass * (1 + f[C::dilation]);
    const P mean = f[C::pressure] + f[C::viscous_pressure];
    Given<Real, Space> given;
    P per[axes];
    each<axes>([&]<int a>() __attribute__((always_inline)) { per[a] = volume * k.force[a]; });
    given.mass = mass;
    each<axes>([&]<int a>()
                   __attribute__((always_inline)) { given.momentum[a] = mass * f[C::velocity + a]; });
    given.stress[0][0] = (mean - s[0]) * per[0], given.stress[1][1] = (mean - s[1]) * per[1];
    given.stress[0][1] = -s[2] * per[1], given.stress[1][0] = -s[2] * per[0];
    if constexpr (axes == 3) {
      given.stress[2][2] = (mean + s[0] + s[1]) * per[2];
      given.stress[0][2] = -s[3] * per[2], given.stress[2][0] = -s[3] * per[0];
      given.stress[1][2] = -s[4] * per[2], given.stress[2][1] = -s[4] * per[1];
    }
    given.hoop = P{};
    if constexpr (has_hoop) given.hoop = (mean + s[0] + s[1]) * per[0] * inverse_radius(f, nodes);
    add(nodes, node_of(f), place, w, given);
  }

  static void scatter(const Band<Real>& band, const Nodes& nodes, const Constants& k) {
    const auto* f = reinterpret_cast<const P*>(band.blocks);
    for (std::size_t b = 0; b < band.count; ++b, f += band.columns) {
      Weights w;
      weigh(f, w);
      give(f, nodes, place_of<Real>(node_of(f)), w, k);
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

  static void sweep(const Band<Real>& band, const Nodes& all_nodes, const Constants& constants,
                    double time_step, const StressUpdate<Real, axes>& stress, SweepReport& report) {
    const Nodes nodes = all_nodes;
    const Constants k = constants;
    const int columns = band.columns;
    const Real dt = static_cast<Real>(time_step), inverse_dt = static_cast<Real>(1 / time_step);
    Extremes<Real> extremes;
    Whole<Real> low_node = node_of(reinterpret_cast<const P*>(band.blocks)), high_node = low_node;
    constexpr int sum_count = 2 + axes;
    double totals[sum_count] = {};
    bool broken = false;
    std::int64_t out_of_step = 0;
    Chunk chunk;
    Gradients<Real, axes> gradients;
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
        chunk.place[b] = place_of<Real>(node_of(f));
      });
      P sums[sum_count] = {};
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
        Mask<Real> moved = rounded<Real>(f[C::position]) != 0;
        each<axes, 1>([&]<int a>() __attribute__((always_inline)) {
          moved |= rounded<Real>(f[C::position + a]) != 0;
        });
        if (__builtin_expect(any(moved), 0)) {
          broken |= change_nodes(f, nodes, band.first_row, band.last_row);
          chunk.place[b] = place_of<Real>(node_of(f));
        }
        low_node = smaller(low_node, node_of(f));
        high_node = larger(high_node, node_of(f));
        weigh(f, chunk.weights[b]);
      });
      each_block([&](P * f, int b) __attribute__((always_inline)) {
        out_of_step += !chunk.place[b].in_step();
        give(f, nodes, chunk.place[b], chunk.weights[b], k);
      });
      for (int n = 0; n < sum_count; ++n)
        for (int l = 0; l < width; ++l) totals[n] += static_cast<double>(sums[n][l]);
    }
    report.transfer_heat += totals[0];
    for (int a = 0; a < axes; ++a) report.momentum[a] += totals[1 + a];
    report.kinetic += 0.5 * totals[1 + axes];
    report.out_of_step += out_of_step;
    report.broken |= broken;
    for (int l = 0; l < width; ++l) {
      const auto low = static_cast<std::int64_t>(low_node[l]), high = static_cast<std::int64_t>(high_node[l]);
      report.lowest_node = low < report.lowest_node ? low : report.lowest_node;
      report.highest_node = high > report.highest_node ? high : report.highest_node;
    }
    stress.report(stress.model, band, extremes, report);
  }
};

}  // namespace mpm::fast::MPM_ISA
