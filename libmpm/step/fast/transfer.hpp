#pragma once
/// Grid to particles and particles to grid, for a pack of particles at a time. Sums are those of p2g.hpp and
/// g2p.hpp, axis by axis: weights are products of one-dimensional functions.
///
/// A pack is in step with the grid when its particles belong to neighbouring cells of a row, one each, in
/// order, beginning at a group of nodes (Blocks::sort makes most of them so). Then the nodes that its lanes
/// ask for lie in two neighbouring groups, and are read as packs. Where a pack is not in step, each lane
/// fetches its own. What a pack gives goes to one of three sums of each node, by column of the stencil, at
/// the lower left node: then neighbouring packs in step never touch the same numbers, and collect_nodes()
/// adds the three.
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"
#include "libmpm/step/fast/weights.hpp"

namespace mpm::fast::MPM_ISA {

/// Whether the stencils of a pack start at the nodes of one group.
template <class Real>
MPM_INLINE bool in_step(Pack<Real> node) {
  const auto first = static_cast<std::ptrdiff_t>(node[0]);
  return first % Lanes<Real>::width == 0 && !any(node - Lanes<Real>::numbers != all(node[0]));
}

/// What a pack sees of a component of the nodes: N, dN/dxi, dN/deta.
template <class Real>
struct Seen {
  Pack<Real> value, along_x, along_y;
};

/// The nodes of a pack: reader(c, j, out) fetches component c in row j of the stencils, column by column.
template <class Real, bool packs_in_step>
struct Reader;

template <class Real>
struct Reader<Real, true> {
  const Real* row[3];

  MPM_INLINE Reader(const Nodes<Real>& n, const Pack<Real>& node) {
    row[0] = n.motion + motion_components * static_cast<std::ptrdiff_t>(node[0]);
    row[1] = row[0] + motion_components * static_cast<std::ptrdiff_t>(n.stride);
    row[2] = row[1] + motion_components * static_cast<std::ptrdiff_t>(n.stride);
  }
  MPM_INLINE void operator()(int component, int j, Pack<Real>* column) const {
    const auto* const group = reinterpret_cast<const Pack<Real>*>(row[j]) + component;
    columns_of(group[0], group[motion_components], column);
  }
};

template <class Real>
struct Reader<Real, false> {
  const Real* motion;
  std::ptrdiff_t to_row;
  std::int32_t at[3][Lanes<Real>::width];  ///< of the columns of the lowest row

  MPM_INLINE Reader(const Nodes<Real>& n, const Pack<Real>& node)
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

template <class Real, bool packs_in_step>
MPM_INLINE Seen<Real> see(const Reader<Real, packs_in_step>& nodes, int component,
                          const PackWeights<Real>& w) {
  using P = Pack<Real>;
  P value[3], slope[3];
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    P n[3];
    nodes(component, j, n);
    value[j] = w.x[0] * n[0] + w.x[1] * n[1] + w.x[2] * n[2];
    slope[j] = w.slope_x[0] * n[0] + w.slope_x[1] * n[1] + w.slope_x[2] * n[2];
  }
  return {w.y[0] * value[0] + w.y[1] * value[1] + w.y[2] * value[2],
          w.y[0] * slope[0] + w.y[1] * slope[1] + w.y[2] * slope[2],
          w.slope_y[0] * value[0] + w.slope_y[1] * value[1] + w.slope_y[2] * value[2]};
}

/// What a pack gives to the grid: mass, momentum, and -V s / (rho0 h) for each slope.
template <class Real>
struct Given {
  Pack<Real> mass, momentum_x, momentum_y, xx_by_x, xy_by_x, xy_by_y, yy_by_y;
};

/// What a pack gives to row j: by column of the stencil, its sums.
template <class Real>
struct GivenToRow {
  Pack<Real> mass, momentum_x, momentum_y, xx_by_x, xy_by_x, xy_by_y, yy_by_y;
  MPM_INLINE GivenToRow(const Given<Real>& g, const PackWeights<Real>& w, int j)
      : mass(w.y[j] * g.mass),
        momentum_x(w.y[j] * g.momentum_x),
        momentum_y(w.y[j] * g.momentum_y),
        xx_by_x(w.y[j] * g.xx_by_x),
        xy_by_x(w.y[j] * g.xy_by_x),
        xy_by_y(w.slope_y[j] * g.xy_by_y),
        yy_by_y(w.slope_y[j] * g.yy_by_y) {}
};

template <class Real>
MPM_INLINE void add_in_step(const Nodes<Real>& nodes, const Pack<Real>& node, const PackWeights<Real>& w,
                            const Given<Real>& given) {
  using P = Pack<Real>;
  constexpr int entries = 3 * sum_components;
  Real* const first = nodes.sums + entries * static_cast<std::ptrdiff_t>(node[0]);
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    const GivenToRow<Real> g(given, w, j);
    P* const sums = reinterpret_cast<P*>(first + j * entries * static_cast<std::ptrdiff_t>(nodes.stride));
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const P x = w.x[i], slope = w.slope_x[i];
      sums[3 * node_mass + i] += x * g.mass;
      sums[3 * momentum_of_x + i] += x * g.momentum_x;
      sums[3 * momentum_of_y + i] += x * g.momentum_y;
      sums[3 * force_of_x + i] = x * g.xy_by_y + (slope * g.xx_by_x + sums[3 * force_of_x + i]);
      sums[3 * force_of_y + i] = x * g.yy_by_y + (slope * g.xy_by_x + sums[3 * force_of_y + i]);
    }
  }
}

template <class Real>
MPM_INLINE void add_one_by_one(const Nodes<Real>& nodes, const Pack<Real>& node, const PackWeights<Real>& w,
                               const Given<Real>& given) {
  using P = Pack<Real>;
  constexpr int width = Lanes<Real>::width, entries = 3 * sum_components;
  for (int j = 0; j < 3; ++j) {
    const GivenToRow<Real> g(given, w, j);
    P sums[entries];
    for (int i = 0; i < 3; ++i) {
      const P x = w.x[i], slope = w.slope_x[i];
      sums[3 * node_mass + i] = x * g.mass;
      sums[3 * momentum_of_x + i] = x * g.momentum_x;
      sums[3 * momentum_of_y + i] = x * g.momentum_y;
      sums[3 * force_of_x + i] = x * g.xy_by_y + slope * g.xx_by_x;
      sums[3 * force_of_y + i] = x * g.yy_by_y + slope * g.xy_by_x;
    }
    for (int l = 0; l < width; ++l) {
      Real* const to = nodes.sums + Nodes<Real>::sum_at(static_cast<std::int32_t>(node[l]) +
                                                        j * static_cast<std::ptrdiff_t>(nodes.stride));
      for (int e = 0; e < entries; ++e) to[e * width] += reinterpret_cast<const Real*>(sums)[e * width + l];
    }
  }
}

}  // namespace mpm::fast::MPM_ISA
