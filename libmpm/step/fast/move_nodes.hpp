#pragma once
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

/// (p, f) of every node of the rows becomes (v + dv, dv) with dv = dt f / m: see grid_update.hpp.
template <class Real>
void move_nodes(const Nodes<Real>& nodes, int first_row, int last_row, double time_step) {
  const Real dt = static_cast<Real>(time_step);
  const Quad<Real> scale = {1, 1, dt, dt};
  const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(first_row + 1) * nodes.stride;
  const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(last_row + 2) * nodes.stride;
  for (std::ptrdiff_t n = begin; n < end; n += 4) {
    const Quad<Real> mass = load_quad(nodes.mass + n);
    const Quad<Real> inverse = mass > 0 ? 1 / mass : Quad<Real>{};
    auto* motion = reinterpret_cast<Quad<Real>*>(nodes.motion + 4 * n);
    Quad<Real> squares[4];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      const Quad<Real> v = motion[i] * (quad<Real>(inverse[i]) * scale);
      const Quad<Real> change = __builtin_shufflevector(v, Quad<Real>{}, 2, 3, 4, 5);
      motion[i] = v + change;
      squares[i] = change * change;
    }
    // lanes 0 and 1 of each
    const Quad<Real> a = __builtin_shufflevector(squares[0], squares[1], 0, 4, 1, 5);
    const Quad<Real> b = __builtin_shufflevector(squares[2], squares[3], 0, 4, 1, 5);
    store_quad<Real>(nodes.square + n,
                     __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7));
  }
}

}  // namespace mpm::fast::MPM_ISA
