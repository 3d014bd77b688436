#pragma once
/// Grid to particle and particle to grid, one particle at a time, with the four components of a node as
/// lanes. Sums are those of p2g.hpp and g2p.hpp, axis by axis: weights are products of one-dimensional
/// functions. Of three weights an axis the middle one is 1 minus the others, of three slopes it is minus the
/// others:
///   sum w_i N_i = N_1 + w_0 (N_0 - N_1) + w_2 (N_2 - N_1),   sum w'_i N_i = w'_0 (N_0 - N_1) + w'_2 (N_2 -
///   N_1)
/// which saves a third of the multiplications and of the weights that have to be fetched.
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"
#include "libmpm/step/fast/weights.hpp"

namespace mpm::fast::MPM_ISA {

/// One particle's number of a pack, in all lanes.
template <class Real>
MPM_INLINE Quad<Real> of_lane(const Pack<Real>& pack, int lane) {
  return repeat<Real>(reinterpret_cast<const Real*>(&pack) + lane);
}

/// What a particle sees of the grid. N = (v_x, v_y, dv_x, dv_y) of a node.
template <class Real>
struct Seen {
  Quad<Real> value;    ///< sum w N
  Quad<Real> along_x;  ///< sum (dw/dxi) N
  Quad<Real> along_y;  ///< sum (dw/deta) N
  Quad<Real> squares;  ///< sum over rows of `square`, column by column; the fourth is foreign
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
  using Q = Quad<Real>;
  const std::ptrdiff_t stride = nodes.stride, first = w.first[lane];
  const Real *motion = nodes.motion + 4 * first, *square = nodes.square + first;
  const Q x0 = of_lane<Real>(w.x[0], lane), x2 = of_lane<Real>(w.x[2], lane);
  const Q s0 = of_lane<Real>(w.slope_x[0], lane), s2 = of_lane<Real>(w.slope_x[2], lane);
  Q value[3], slope[3];
  const auto along_row = [&](int j) __attribute__((always_inline)) {
    const auto* row = reinterpret_cast<const Q*>(motion + 4 * j * stride);
    const Q middle = row[1], left = row[0] - middle, right = row[2] - middle;
    value[j] = middle + (x0 * left + x2 * right);
    slope[j] = s0 * left + s2 * right;
  };
  along_row(1);
  const Q square1 = load_quad(square + stride);
  along_row(0);
  const Q y0 = of_lane<Real>(w.y[0], lane), slope_y0 = of_lane<Real>(w.slope_y[0], lane);
  const Q low = value[0] - value[1];
  Seen<Real> seen;
  seen.value = value[1] + y0 * low;
  seen.along_y = slope_y0 * low;
  seen.along_x = slope[1] + y0 * (slope[0] - slope[1]);
  seen.squares = square1 + y0 * (load_quad(square) - square1);
  along_row(2);
  const Q y2 = of_lane<Real>(w.y[2], lane), slope_y2 = of_lane<Real>(w.slope_y[2], lane);
  const Q high = value[2] - value[1];
  seen.value += y2 * high;
  seen.along_y += slope_y2 * high;
  seen.along_x += y2 * (slope[2] - slope[1]);
  seen.squares += y2 * (load_quad(square + 2 * stride) - square1);
  return seen;
}

/// `mass_y`: mass times the weight of each row, one pack a row.
template <class Real>
MPM_INLINE void scatter(Nodes<Real> nodes, const PackWeights<Real>& w, int lane, const Given<Real>& given,
                        const Pack<Real>* mass_y) {
  using Q = Quad<Real>;
  const std::ptrdiff_t stride = nodes.stride, first = w.first[lane];
  Real *motion = nodes.motion + 4 * first, *mass = nodes.mass + first;
  const Q x0 = of_lane<Real>(w.x[0], lane), x2 = of_lane<Real>(w.x[2], lane);
  const Q s0 = of_lane<Real>(w.slope_x[0], lane), s2 = of_lane<Real>(w.slope_x[2], lane);
  const auto to_row = [&](int j, Q p, Q q) __attribute__((always_inline)) {
    auto* row = reinterpret_cast<Q*>(motion + 4 * j * stride);
    const Q left = x0 * p + s0 * q, right = x2 * p + s2 * q;
    row[0] += left;
    row[2] += right;
    row[1] += p - (left + right);
    Real* masses = mass + j * stride;
    store_quad<Real>(masses, load_quad(masses) + of_lane<Real>(mass_y[j], lane) * given.weight_x);
  };
  const auto by_row = [&](int j) __attribute__((always_inline)) {
    return __builtin_shufflevector(of_lane<Real>(w.y[j], lane), of_lane<Real>(w.slope_y[j], lane), 0, 1, 6,
                                   7) *
           given.by_weight;
  };
  const Q p0 = by_row(0), q0 = of_lane<Real>(w.y[0], lane) * given.by_slope_x;
  to_row(0, p0, q0);
  const Q p2 = by_row(2), q2 = of_lane<Real>(w.y[2], lane) * given.by_slope_x;
  to_row(2, p2, q2);
  const Q whole = __builtin_shufflevector(given.by_weight, Q{}, 0, 1, 6, 7);  // over the rows
  to_row(1, whole - (p0 + p2), given.by_slope_x - (q0 + q2));
}

}  // namespace mpm::fast::MPM_ISA
