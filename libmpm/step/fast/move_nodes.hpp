#pragma once
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

/// Adds up the three sums of each component (transfer.hpp) and clears them.
template <class Real>
void collect_nodes(const Nodes<Real>& nodes, int first_row, int last_row) {
  using P = Pack<Real>;
  constexpr int entries = 3 * sum_components;
  constexpr int to[] = {motion_mass, motion_x, motion_y, change_x, change_y};
  const std::ptrdiff_t groups = nodes.stride / Lanes<Real>::width;
  auto* sums = reinterpret_cast<P*>(nodes.sums) + (first_row + 1) * groups * entries;
  auto* motion = reinterpret_cast<P*>(nodes.motion) + (first_row + 1) * groups * motion_components;
  P before[entries] = {};  // the last group of a row gives nothing to the next row
  for (std::ptrdiff_t g = (first_row + 1) * groups; g < (last_row + 2) * groups; ++g) {
#pragma GCC unroll 5
    for (int c = 0; c < sum_components; ++c) {
      P* const of = sums + 3 * c;
      const P one = of[1], two = of[2];
      motion[to[c]] = of[0] + (shifted<1>(before[3 * c + 1], one) + shifted<2>(before[3 * c + 2], two));
      before[3 * c + 1] = one;
      before[3 * c + 2] = two;
      of[0] = of[1] = of[2] = P{};
    }
    sums += entries;
    motion += motion_components;
  }
}

/// (p, f) of every node of the rows becomes (v + dv, dv) with dv = dt f / m: see grid_update.hpp.
template <class Real>
void move_nodes(const Nodes<Real>& nodes, int first_row, int last_row, double time_step) {
  using P = Pack<Real>;
  const Real dt = static_cast<Real>(time_step);
  const std::ptrdiff_t groups = nodes.stride / Lanes<Real>::width;
  auto* group = reinterpret_cast<P*>(nodes.motion) + (first_row + 1) * groups * motion_components;
  for (std::ptrdiff_t g = (first_row + 1) * groups; g < (last_row + 2) * groups; ++g) {
    const P mass = group[motion_mass];
    const P inverse = mass > 0 ? 1 / mass : P{};
    const P dx = group[change_x] * inverse * dt, dy = group[change_y] * inverse * dt;
    group[motion_x] = group[motion_x] * inverse + dx;
    group[motion_y] = group[motion_y] * inverse + dy;
    group[change_x] = dx;
    group[change_y] = dy;
    group[change_square] = dx * dx + dy * dy;
    group += motion_components;
  }
}

}  // namespace mpm::fast::MPM_ISA
