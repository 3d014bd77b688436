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
MPM_INLINE Place<Real> place_of(Whole<Real> node) {
  constexpr int width = Lanes<Real>::width, all_lanes = (1 << width) - 1;
  const Whole<Real> start = node - Lanes<Real>::numbers;
  Place<Real> place;
  place.first = static_cast<std::int32_t>(start[0]);
  int away = bits(start != all_whole<Real>(place.first));
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
    const int others = bits(start != all_whole<Real>(first));
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

/// The lines of a stencil in an array with `each` numbers of a node: how far they are from the first one.
template <int axes, int each>
struct Lines {
  std::ptrdiff_t to_row, to_slice;

  template <class Real>
  MPM_INLINE explicit Lines(const Nodes<Real, axes>& nodes)
      : to_row(each * static_cast<std::ptrdiff_t>(nodes.to_row)),
        to_slice(each * static_cast<std::ptrdiff_t>(nodes.stride)) {}
  MPM_INLINE std::ptrdiff_t operator[](int line) const {
    return axes == 3 ? line / 3 * to_row + line % 3 * to_slice : line * to_row;
  }
};

/// What a pack sees of a component of the nodes: N, its slopes along the axes [1/cells], and with the weights
/// of the hoop.
template <class Real, int axes>
struct Seen {
  Pack<Real> value, along[axes], hoop;
};

enum class Order { in_step, with_strays, scattered };

/// The nodes of a pack: reader(c, n, out) fetches component c in line n of the stencils, column by column.
template <class Real, int axes, Order>
struct Reader;

template <class Real, int axes>
struct Reader<Real, axes, Order::in_step> {
  static constexpr int components = Motion<axes>::components;
  const Real* line[lines<axes>];

  MPM_INLINE Reader(const Nodes<Real, axes>& n, const Whole<Real>&, const Place<Real>& place) {
    const Lines<axes, components> to(n);
    const Real* const first = n.motion + components * static_cast<std::ptrdiff_t>(place.first);
    each<lines<axes>>([&]<int r>() __attribute__((always_inline)) { line[r] = first + to[r]; });
  }
  MPM_INLINE void operator()(int component, int r, Pack<Real>* column) const {
    const auto* const group = reinterpret_cast<const Pack<Real>*>(line[r]) + component;
    columns_of(group[0], group[components], column);
  }
};

template <class Real, int axes>
struct Reader<Real, axes, Order::with_strays> {
  static constexpr int components = Motion<axes>::components;
  Reader<Real, axes, Order::in_step> others;
  const Real* motion;
  Lines<axes, components> to;
  int strays;
  Mask<Real> lane[Place<Real>::most_strays];
  std::int32_t at[Place<Real>::most_strays][3];  ///< of the columns of a stray's first line

  MPM_INLINE Reader(const Nodes<Real, axes>& n, const Whole<Real>& node, const Place<Real>& place)
      : others(n, node, place), motion(n.motion), to(n), strays(place.strays) {
    for (int s = 0; s < strays; ++s) {
      lane[s] = Lanes<Real>::numbers == all_whole<Real>(place.stray[s]);
      for (int i = 0; i < 3; ++i)
        at[s][i] =
            static_cast<std::int32_t>(n.motion_at(static_cast<std::int32_t>(node[place.stray[s]]) + i));
    }
  }
  MPM_INLINE void operator()(int component, int r, Pack<Real>* column) const {
    others(component, r, column);
    const Real* const from = motion + to[r] + component * Lanes<Real>::width;
    for (int s = 0; s < strays; ++s)
      for (int i = 0; i < 3; ++i) column[i] = lane[s] ? all(from[at[s][i]]) : column[i];
  }
};

template <class Real, int axes>
struct Reader<Real, axes, Order::scattered> {
  const Real* motion;
  Lines<axes, Motion<axes>::components> to;
  std::int32_t at[3][Lanes<Real>::width];  ///< of the columns of the first line

  MPM_INLINE Reader(const Nodes<Real, axes>& n, const Whole<Real>& node, const Place<Real>&)
      : motion(n.motion), to(n) {
    for (int l = 0; l < Lanes<Real>::width; ++l)
      for (int i = 0; i < 3; ++i)
        at[i][l] = static_cast<std::int32_t>(n.motion_at(static_cast<std::int32_t>(node[l]) + i));
  }
  MPM_INLINE void operator()(int component, int r, Pack<Real>* column) const {
    const Real* const from = motion + to[r] + component * Lanes<Real>::width;
    for (int i = 0; i < 3; ++i) column[i] = fetched(from, at[i]);
  }
};

/// Over the three nodes of an axis.
template <class P>
MPM_INLINE P weighted(const P* w, const P* of) {
  return w[0] * of[0] + w[1] * of[1] + w[2] * of[2];
}

template <class Real, Order order, class Space>
MPM_INLINE Seen<Real, Space::axes> see(const Reader<Real, Space::axes, order>& nodes, int component,
                                       const PackWeights<Real, Space>& w) {
  using P = Pack<Real>;
  constexpr int axes = Space::axes;
  P value[3], slope_x[3];
  [[maybe_unused]] P slope_z[3], hoop{};
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    P n[3];
    if constexpr (axes == 3) {
      P of_line[3], slope_of_line[3];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) {
        nodes(component, 3 * j + k, n);
        of_line[k] = weighted(w.value[0], n);
        slope_of_line[k] = weighted(w.slope[0], n);
      }
      value[j] = weighted(w.value[2], of_line);
      slope_x[j] = weighted(w.value[2], slope_of_line);
      slope_z[j] = weighted(w.slope[2], of_line);
    } else {
      nodes(component, j, n);
      value[j] = weighted(w.value[0], n);
      slope_x[j] = weighted(w.slope[0], n);
    }
    if constexpr (Space::has_hoop) hoop += w.value[1][j] * weighted(w.hoop, n);
  }
  if constexpr (axes == 3)
    return {weighted(w.value[1], value),
            {weighted(w.value[1], slope_x), weighted(w.slope[1], value), weighted(w.value[1], slope_z)},
            hoop};
  else
    return {weighted(w.value[1], value), {weighted(w.value[1], slope_x), weighted(w.slope[1], value)}, hoop};
}

/// What a pack gives to the grid: mass, momentum, and -V s / (rho0 h) by component of the force and axis of
/// the slope, and for the hoop.
template <class Real, class Space>
struct Given {
  static constexpr int axes = Space::axes;
  Pack<Real> mass, momentum[axes], stress[axes][axes], hoop;

  /// That of some lanes.
  MPM_INLINE Given of(Mask<Real> lanes) const {
    Given some;
    some.mass = where<Real>(lanes, mass);
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      some.momentum[a] = where<Real>(lanes, momentum[a]);
      each<axes>([&]<int b>() __attribute__((always_inline)) {
        some.stress[a][b] = where<Real>(lanes, stress[a][b]);
      });
    });
    some.hoop = Space::has_hoop ? where<Real>(lanes, hoop) : hoop;
    return some;
  }
};

/// What a pack gives to a line of the stencil: to a node of weight N and slope N' along x
///   mass N, momentum N, across N + along N' of the force, and of the hoop's its own weight.
template <class Real, class Space>
struct GivenToLine {
  static constexpr int axes = Space::axes;
  Pack<Real> mass, momentum[axes], along[axes], across[axes], hoop;

  MPM_INLINE GivenToLine(const Given<Real, Space>& g, const PackWeights<Real, Space>& w, int line) {
    Pack<Real> weight, slope_y;
    [[maybe_unused]] Pack<Real> slope_z;
    if constexpr (axes == 3) {
      const int j = line / 3, k = line % 3;
      weight = w.value[1][j] * w.value[2][k];
      slope_y = w.slope[1][j] * w.value[2][k];
      slope_z = w.value[1][j] * w.slope[2][k];
    } else {
      weight = w.value[1][line];
      slope_y = w.slope[1][line];
    }
    mass = weight * g.mass;
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      momentum[a] = weight * g.momentum[a];
      along[a] = weight * g.stress[a][0];
      across[a] = slope_y * g.stress[a][1];
      if constexpr (axes == 3) across[a] += slope_z * g.stress[a][2];
    });
    hoop = Space::has_hoop ? weight * g.hoop : g.hoop;
  }
};

/// Adds what it gives to column i of the line to that column's entry of each sum (Nodes::sums); `first`: in
/// place of what is there.
template <bool first, class Real, class Space>
MPM_INLINE void add_column(const GivenToLine<Real, Space>& g, const PackWeights<Real, Space>& w, int i,
                           Pack<Real>* sums) {
  using S = Sums<Space::axes>;
  const Pack<Real> x = w.value[0][i], slope = w.slope[0][i];
  const auto add = [](Pack<Real> & sum, Pack<Real> more) __attribute__((always_inline)) {
    sum = first ? more : sum + more;
  };
  add(sums[3 * S::mass + i], x * g.mass);
  each<Space::axes>([&]<int a>() __attribute__((always_inline)) {
    add(sums[3 * (S::momentum + a) + i], x * g.momentum[a]);
    Pack<Real>& force = sums[3 * (S::force + a) + i];
    force = x * g.across[a] + (first ? slope * g.along[a] : slope * g.along[a] + force);
    if constexpr (Space::has_hoop && a == 0) force += w.hoop[i] * g.hoop;
  });
}

template <class Real, class Space>
MPM_INLINE void add_in_step(const Nodes<Real, Space::axes>& nodes, std::int32_t first_node,
                            const PackWeights<Real, Space>& w, const Given<Real, Space>& given) {
  constexpr int axes = Space::axes, entries = Nodes<Real, axes>::entries;
  const Lines<axes, entries> to(nodes);
  Real* const first = nodes.sums + entries * static_cast<std::ptrdiff_t>(first_node);
#pragma GCC unroll 9
  for (int r = 0; r < lines<axes>; ++r) {
    const GivenToLine<Real, Space> g(given, w, r);
    auto* const sums = reinterpret_cast<Pack<Real>*>(first + to[r]);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) add_column<false>(g, w, i, sums);
  }
}

/// Of the strays.
template <class Real, class Space>
MPM_INLINE void add_one_by_one(const Nodes<Real, Space::axes>& nodes, const Whole<Real>& node,
                               const Place<Real>& place, const PackWeights<Real, Space>& w,
                               const Given<Real, Space>& given) {
  constexpr int axes = Space::axes, width = Lanes<Real>::width, entries = Nodes<Real, axes>::entries;
  const Lines<axes, entries> to(nodes);
  for (int r = 0; r < lines<axes>; ++r) {
    const GivenToLine<Real, Space> g(given, w, r);
    Pack<Real> sums[entries];
    for (int i = 0; i < 3; ++i) add_column<true>(g, w, i, sums);
    for (int s = 0; s < place.strays; ++s) {
      const int l = place.stray[s];
      Real* const sum = nodes.sums + nodes.sum_at(static_cast<std::int32_t>(node[l])) + to[r];
      for (int e = 0; e < entries; ++e) sum[e * width] += reinterpret_cast<const Real*>(sums)[e * width + l];
    }
  }
}

template <class Real, class Space>
MPM_INLINE void add(const Nodes<Real, Space::axes>& nodes, const Whole<Real>& node, const Place<Real>& place,
                    const PackWeights<Real, Space>& w, const Given<Real, Space>& given) {
  if (place.in_step()) {
    add_in_step(nodes, place.first, w, given);
    return;
  }
  if (!place.scattered())
    add_in_step(nodes, place.first, w, given.of(node - Lanes<Real>::numbers == all_whole<Real>(place.first)));
  add_one_by_one(nodes, node, place, w, given);
}

}  // namespace mpm::fast::MPM_ISA
