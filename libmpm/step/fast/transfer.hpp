#pragma once
/// Grid to particle and particle to grid, one particle at a time, with the four components of a node as
/// lanes. Sums are those of p2g.hpp and g2p.hpp, axis by axis: weights are products of one-dimensional
/// functions.
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"
#include "libmpm/step/fast/weights.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real>
MPM_INLINE const Real* of_lane(const Pack<Real>& pack, int lane) {
  return reinterpret_cast<const Real*>(&pack) + lane;
}

/// What a particle sees of the grid. N = (v_x, v_y, dv_x, dv_y) of a node.
template <class Real>
struct Seen {
  Quad<Real> value;    ///< sum w N
  Quad<Real> along_x;  ///< sum (dw/dxi) N
  Quad<Real> along_y;  ///< sum (dw/deta) N
  Quad<Real> squares;  ///< sum over rows of |dv|^2, column by column; the fourth is foreign
};

/// What a particle gives to the grid.
template <class Real>
struct Given {
  Quad<Real> by_weight;   ///< (m v_x, m v_y) for w and -V (s_xy, s_yy) / (rho0 hy) for dw/deta
  Quad<Real> by_slope_x;  ///< (0, 0) and -V (s_xx, s_xy) / (rho0 hx) for dw/dxi
  Quad<Real> weight_x;    ///< weights of the three columns, 0
};

template <class Real>
MPM_INLINE Seen<Real> gather(Nodes<Real> nodes, const PackWeights<Real>& w, int lane) {
  const Real* motion = nodes.motion + 4 * static_cast<std::ptrdiff_t>(w.first[lane]);
  const Real* square = nodes.square + w.first[lane];
  const Quad<Real> x0 = repeat<Real>(of_lane<Real>(w.x[0], lane)),
                   x1 = repeat<Real>(of_lane<Real>(w.x[1], lane)),
                   x2 = repeat<Real>(of_lane<Real>(w.x[2], lane));
  const Quad<Real> s0 = repeat<Real>(of_lane<Real>(w.slope_x[0], lane)),
                   s1 = repeat<Real>(of_lane<Real>(w.slope_x[1], lane)),
                   s2 = repeat<Real>(of_lane<Real>(w.slope_x[2], lane));
  Seen<Real> seen;
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    const auto* row = reinterpret_cast<const Quad<Real>*>(motion + 4 * j * nodes.stride);
    const Quad<Real> a = row[0], b = row[1], c = row[2];
    const Quad<Real> value = x0 * a + x1 * b + x2 * c, slope = s0 * a + s1 * b + s2 * c;
    const Quad<Real> y = repeat<Real>(of_lane<Real>(w.y[j], lane)),
                     slope_y = repeat<Real>(of_lane<Real>(w.slope_y[j], lane));
    const Quad<Real> squares = y * load_quad(square + j * nodes.stride);
    if (j == 0) {
      seen.value = y * value, seen.along_x = y * slope, seen.along_y = slope_y * value,
      seen.squares = squares;
    } else {
      seen.value += y * value, seen.along_x += y * slope, seen.along_y += slope_y * value,
          seen.squares += squares;
    }
  }
  return seen;
}

/// `mass_y`: mass times the weight of each row, one pack a row.
template <class Real>
MPM_INLINE void scatter(Nodes<Real> nodes, const PackWeights<Real>& w, int lane, const Given<Real>& given,
                        const Pack<Real>* mass_y) {
  Real* motion = nodes.motion + 4 * static_cast<std::ptrdiff_t>(w.first[lane]);
  Real* mass = nodes.mass + w.first[lane];
  const Quad<Real> x0 = repeat<Real>(of_lane<Real>(w.x[0], lane)),
                   x1 = repeat<Real>(of_lane<Real>(w.x[1], lane)),
                   x2 = repeat<Real>(of_lane<Real>(w.x[2], lane));
  const Quad<Real> s0 = repeat<Real>(of_lane<Real>(w.slope_x[0], lane)),
                   s1 = repeat<Real>(of_lane<Real>(w.slope_x[1], lane)),
                   s2 = repeat<Real>(of_lane<Real>(w.slope_x[2], lane));
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    auto* row = reinterpret_cast<Quad<Real>*>(motion + 4 * j * nodes.stride);
    const Quad<Real> y = repeat<Real>(of_lane<Real>(w.y[j], lane)),
                     slope_y = repeat<Real>(of_lane<Real>(w.slope_y[j], lane));
    const Quad<Real> p = __builtin_shufflevector(y, slope_y, 0, 1, 6, 7) * given.by_weight;
    const Quad<Real> q = y * given.by_slope_x;
    row[0] += x0 * p + s0 * q;
    row[1] += x1 * p + s1 * q;
    row[2] += x2 * p + s2 * q;
    Real* masses = mass + j * nodes.stride;
    store_quad<Real>(masses,
                     load_quad(masses) + repeat<Real>(of_lane<Real>(mass_y[j], lane)) * given.weight_x);
  }
}

}  // namespace mpm::fast::MPM_ISA
