#pragma once
/// Grid to particles and particles to grid, for a pack of particles at a time. Sums are those of p2g.hpp and
/// g2p.hpp, axis by axis: weights are products of one-dimensional functions.
///
/// A pack is in step with the grid when its particles belong to neighbouring cells of a row, one each, in
/// order, beginning at a group of nodes (Blocks::sort makes most of them so). Then the nodes that its lanes
/// ask for lie in two neighbouring groups, and are read as packs. Lanes that have strayed to other cells
/// since fetch their own; where most have, all do. What a pack gives goes to one of three sums of each node,
/// by column of the stencil, at the lower left node: then neighbouring packs in step never touch the same
/// numbers, and collect_nodes() adds the three.
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"
#include "libmpm/step/fast/weights.hpp"

namespace mpm::fast::MPM_ISA {

/// Where the stencils of a pack start: lane l at node `first` + l, strays elsewhere.
template <class Real>
struct Place {
  static constexpr int width = Lanes<Real>::width;
  static constexpr int most_strays = width / 2;  ///< of a pack that is read as one

  std::int32_t first = 0;
  int strays = width;  ///< all, where no group of nodes has enough
  std::int32_t stray[width];

  bool in_step() const { return strays == 0; }
  bool scattered() const { return strays == width; }
};

template <class Real>
MPM_INLINE Place<Real> place_of(Pack<Real> node) {
  constexpr int width = Lanes<Real>::width, all_lanes = (1 << width) - 1;
  const Pack<Real> start = node - Lanes<Real>::numbers;
  Place<Real> place;
  place.first = static_cast<std::int32_t>(start[0]);
  int away = bits(start != all(start[0]));
  if (__builtin_expect(place.first % width == 0 && away == 0, 1)) {
    place.strays = 0;
    return place;
  }
  // Where lane 0 has strayed, the group with the most lanes is nearly always that of the middle lane or of
  // the last one. Empty lanes count like others: they lie where those of their block do.
  constexpr int candidates[] = {width / 2, width - 1};
  int fewest = place.first % width == 0 ? __builtin_popcount(static_cast<unsigned>(away)) : width;
  for (const int lane : candidates) {
    const auto first = static_cast<std::int32_t>(start[lane]);
    const int others = bits(start != all(start[lane]));
    const int count = __builtin_popcount(static_cast<unsigned>(others));
    if (first % width != 0 || count >= fewest) continue;
    fewest = count, away = others, place.first = first;
  }
  const bool scattered = fewest > Place<Real>::most_strays;
  if (scattered) away = all_lanes;
  place.strays = 0;
  for (; away != 0; away &= away - 1)
    place.stray[place.strays++] = __builtin_ctz(static_cast<unsigned>(away));
  return place;
}

/// What a pack sees of a component of the nodes: N, dN/dxi, dN/deta, and with the weights of the hoop.
template <class Real>
struct Seen {
  Pack<Real> value, along_x, along_y, hoop;
};

enum class Order { in_step, with_strays, scattered };

/// The nodes of a pack: reader(c, j, out) fetches component c in row j of the stencils, column by column.
template <class Real, Order>
struct Reader;

template <class Real>
struct Reader<Real, Order::in_step> {
  const Real* row[3];

  MPM_INLINE Reader(const Nodes<Real>& n, const Pack<Real>&, const Place<Real>& place) {
    row[0] = n.motion + motion_components * static_cast<std::ptrdiff_t>(place.first);
    row[1] = row[0] + motion_components * static_cast<std::ptrdiff_t>(n.stride);
    row[2] = row[1] + motion_components * static_cast<std::ptrdiff_t>(n.stride);
  }
  MPM_INLINE void operator()(int component, int j, Pack<Real>* column) const {
    const auto* const group = reinterpret_cast<const Pack<Real>*>(row[j]) + component;
    columns_of(group[0], group[motion_components], column);
  }
};

template <class Real>
struct Reader<Real, Order::with_strays> {
  Reader<Real, Order::in_step> others;
  const Real* motion;
  std::ptrdiff_t to_row;
  int strays;
  Mask<Real> lane[Place<Real>::most_strays];
  std::int32_t at[Place<Real>::most_strays][3];  ///< of the columns of a stray's lowest row

  MPM_INLINE Reader(const Nodes<Real>& n, const Pack<Real>& node, const Place<Real>& place)
      : others(n, node, place),
        motion(n.motion),
        to_row(motion_components * static_cast<std::ptrdiff_t>(n.stride)),
        strays(place.strays) {
    for (int s = 0; s < strays; ++s) {
      lane[s] = Lanes<Real>::numbers == all(static_cast<Real>(place.stray[s]));
      for (int i = 0; i < 3; ++i)
        at[s][i] = static_cast<std::int32_t>(
            Nodes<Real>::motion_at(static_cast<std::int32_t>(node[place.stray[s]]) + i));
    }
  }
  MPM_INLINE void operator()(int component, int j, Pack<Real>* column) const {
    others(component, j, column);
    const Real* const from = motion + j * to_row + component * Lanes<Real>::width;
    for (int s = 0; s < strays; ++s)
      for (int i = 0; i < 3; ++i) column[i] = lane[s] ? all(from[at[s][i]]) : column[i];
  }
};

template <class Real>
struct Reader<Real, Order::scattered> {
  const Real* motion;
  std::ptrdiff_t to_row;
  std::int32_t at[3][Lanes<Real>::width];  ///< of the columns of the lowest row

  MPM_INLINE Reader(const Nodes<Real>& n, const Pack<Real>& node, const Place<Real>&)
      : motion(n.motion), to_row(motion_components * static_cast<std::ptrdiff_t>(n.stride)) {
    for (int l = 0; l < Lanes<Real>::width; ++l)
      for (int i = 0; i < 3; ++i)
        at[i][l] = static_cast<std::int32_t>(Nodes<Real>::motion_at(static_cast<std::int32_t>(node[l]) + i));
  }
  MPM_INLINE void operator()(int component, int j, Pack<Real>* column) const {
    const Real* const from = motion + j * to_row + component * Lanes<Real>::width;
    for (int i = 0; i < 3; ++i) column[i] = fetched(from, at[i]);
  }
};

template <class Real, Order order, bool has_hoop>
MPM_INLINE Seen<Real> see(const Reader<Real, order>& nodes, int component,
                          const PackWeights<Real, has_hoop>& w) {
  using P = Pack<Real>;
  P value[3], slope[3];
  [[maybe_unused]] P hoop{};
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    P n[3];
    nodes(component, j, n);
    value[j] = w.x[0] * n[0] + w.x[1] * n[1] + w.x[2] * n[2];
    slope[j] = w.slope_x[0] * n[0] + w.slope_x[1] * n[1] + w.slope_x[2] * n[2];
    if constexpr (has_hoop) hoop += w.y[j] * (w.hoop[0] * n[0] + w.hoop[1] * n[1] + w.hoop[2] * n[2]);
  }
  return {w.y[0] * value[0] + w.y[1] * value[1] + w.y[2] * value[2],
          w.y[0] * slope[0] + w.y[1] * slope[1] + w.y[2] * slope[2],
          w.slope_y[0] * value[0] + w.slope_y[1] * value[1] + w.slope_y[2] * value[2], hoop};
}

/// What a pack gives to the grid: mass, momentum, and -V s / (rho0 h) for each slope and for the hoop.
template <class Real, bool has_hoop>
struct Given {
  Pack<Real> mass, momentum_x, momentum_y, xx_by_x, xy_by_x, xy_by_y, yy_by_y, hoop;

  /// That of some lanes.
  MPM_INLINE Given of(Mask<Real> lanes) const {
    return {where<Real>(lanes, mass),       where<Real>(lanes, momentum_x),
            where<Real>(lanes, momentum_y), where<Real>(lanes, xx_by_x),
            where<Real>(lanes, xy_by_x),    where<Real>(lanes, xy_by_y),
            where<Real>(lanes, yy_by_y),    has_hoop ? where<Real>(lanes, hoop) : hoop};
  }
};

/// What a pack gives to row j: by column of the stencil, its sums.
template <class Real, bool has_hoop>
struct GivenToRow {
  Pack<Real> mass, momentum_x, momentum_y, xx_by_x, xy_by_x, xy_by_y, yy_by_y, hoop;
  MPM_INLINE GivenToRow(const Given<Real, has_hoop>& g, const PackWeights<Real, has_hoop>& w, int j)
      : mass(w.y[j] * g.mass),
        momentum_x(w.y[j] * g.momentum_x),
        momentum_y(w.y[j] * g.momentum_y),
        xx_by_x(w.y[j] * g.xx_by_x),
        xy_by_x(w.y[j] * g.xy_by_x),
        xy_by_y(w.slope_y[j] * g.xy_by_y),
        yy_by_y(w.slope_y[j] * g.yy_by_y),
        hoop(has_hoop ? w.y[j] * g.hoop : g.hoop) {}
};

template <class Real, bool has_hoop>
MPM_INLINE void add_in_step(const Nodes<Real>& nodes, std::int32_t first_node,
                            const PackWeights<Real, has_hoop>& w, const Given<Real, has_hoop>& given) {
  using P = Pack<Real>;
  constexpr int entries = 3 * sum_components;
  Real* const first = nodes.sums + entries * static_cast<std::ptrdiff_t>(first_node);
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    const GivenToRow<Real, has_hoop> g(given, w, j);
    P* const sums = reinterpret_cast<P*>(first + j * entries * static_cast<std::ptrdiff_t>(nodes.stride));
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const P x = w.x[i], slope = w.slope_x[i];
      sums[3 * node_mass + i] += x * g.mass;
      sums[3 * momentum_of_x + i] += x * g.momentum_x;
      sums[3 * momentum_of_y + i] += x * g.momentum_y;
      sums[3 * force_of_x + i] = x * g.xy_by_y + (slope * g.xx_by_x + sums[3 * force_of_x + i]);
      if constexpr (has_hoop) sums[3 * force_of_x + i] += w.hoop[i] * g.hoop;
      sums[3 * force_of_y + i] = x * g.yy_by_y + (slope * g.xy_by_x + sums[3 * force_of_y + i]);
    }
  }
}

/// Of the strays.
template <class Real, bool has_hoop>
MPM_INLINE void add_one_by_one(const Nodes<Real>& nodes, const Pack<Real>& node, const Place<Real>& place,
                               const PackWeights<Real, has_hoop>& w, const Given<Real, has_hoop>& given) {
  using P = Pack<Real>;
  constexpr int width = Lanes<Real>::width, entries = 3 * sum_components;
  for (int j = 0; j < 3; ++j) {
    const GivenToRow<Real, has_hoop> g(given, w, j);
    P sums[entries];
    for (int i = 0; i < 3; ++i) {
      const P x = w.x[i], slope = w.slope_x[i];
      sums[3 * node_mass + i] = x * g.mass;
      sums[3 * momentum_of_x + i] = x * g.momentum_x;
      sums[3 * momentum_of_y + i] = x * g.momentum_y;
      sums[3 * force_of_x + i] = x * g.xy_by_y + slope * g.xx_by_x;
      if constexpr (has_hoop) sums[3 * force_of_x + i] += w.hoop[i] * g.hoop;
      sums[3 * force_of_y + i] = x * g.yy_by_y + slope * g.xy_by_x;
    }
    for (int s = 0; s < place.strays; ++s) {
      const int l = place.stray[s];
      Real* const to = nodes.sums + Nodes<Real>::sum_at(static_cast<std::int32_t>(node[l]) +
                                                        j * static_cast<std::ptrdiff_t>(nodes.stride));
      for (int e = 0; e < entries; ++e) to[e * width] += reinterpret_cast<const Real*>(sums)[e * width + l];
    }
  }
}

template <class Real, bool has_hoop>
MPM_INLINE void add(const Nodes<Real>& nodes, const Pack<Real>& node, const Place<Real>& place,
                    const PackWeights<Real, has_hoop>& w, const Given<Real, has_hoop>& given) {
  if (place.in_step()) {
    add_in_step(nodes, place.first, w, given);
    return;
  }
  const auto first = static_cast<Real>(place.first);
  if (!place.scattered())
    add_in_step(nodes, place.first, w, given.of(node - Lanes<Real>::numbers == all(first)));
  add_one_by_one(nodes, node, place, w, given);
}

}  // namespace mpm::fast::MPM_ISA
