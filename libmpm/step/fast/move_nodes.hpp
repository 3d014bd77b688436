#pragma once
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

/// Adds up the three sums of each component (transfer.hpp) and clears them.
template <class Real, int axes>
void collect_nodes(const Nodes<Real, axes>& nodes, int first_row, int last_row) {
  using P = Pack<Real>;
  using M = Motion<axes>;
  constexpr int entries = Nodes<Real, axes>::entries;
  constexpr auto to = [](int sum) { return sum == 0 ? int{M::mass} : M::velocity + sum - 1; };
  static_assert(M::change == M::velocity + axes, "forces follow momenta, as in Sums");
  const std::ptrdiff_t groups = nodes.to_row / Lanes<Real>::width;
  auto* sums = reinterpret_cast<P*>(nodes.sums) + (first_row + 1) * groups * entries;
  auto* motion = reinterpret_cast<P*>(nodes.motion) + (first_row + 1) * groups * M::components;
  P before[entries] = {};  // the last group of a line gives nothing to the next line
  for (std::ptrdiff_t g = (first_row + 1) * groups; g < (last_row + 2) * groups; ++g) {
#pragma GCC unroll 7
    for (int c = 0; c < Sums<axes>::components; ++c) {
      P* const of = sums + 3 * c;
      const P one = of[1], two = of[2];
      motion[to(c)] = of[0] + (shifted<1>(before[3 * c + 1], one) + shifted<2>(before[3 * c + 2], two));
      before[3 * c + 1] = one;
      before[3 * c + 2] = two;
      of[0] = of[1] = of[2] = P{};
    }
    sums += entries;
    motion += M::components;
  }
}

/// (p, f) of every node of the rows becomes (v + dv, dv) with dv = dt f / m: see grid_update.hpp.
template <class Real, int axes>
void move_nodes(const Nodes<Real, axes>& nodes, int first_row, int last_row, double time_step) {
  using P = Pack<Real>;
  using M = Motion<axes>;
  const Real dt = static_cast<Real>(time_step);
  const std::ptrdiff_t groups = nodes.to_row / Lanes<Real>::width;
  auto* group = reinterpret_cast<P*>(nodes.motion) + (first_row + 1) * groups * M::components;
  for (std::ptrdiff_t g = (first_row + 1) * groups; g < (last_row + 2) * groups; ++g) {
    const P mass = group[M::mass];
    const P inverse = mass > 0 ? 1 / mass : P{};
    P change[axes];
    each<axes>([&]<int a>() __attribute__((always_inline)) {
      change[a] = group[M::change + a] * inverse * dt;
      group[M::velocity + a] = group[M::velocity + a] * inverse + change[a];
      group[M::change + a] = change[a];
    });
    group[M::change_square] = square_of<axes>(change);
    group += M::components;
  }
}

}  // namespace mpm::fast::MPM_ISA
