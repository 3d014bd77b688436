#pragma once
/// The return to a yield surface whose stress depends on strain in a way that only a search can solve.
#include "libmpm/material/strength/j2.hpp"

namespace mpm {

/// What a return leaves, for each lane.
template <class N>
struct Returned {
  N increment{};               ///< dp [1]
  N left = Number<N>::all(1);  ///< of the trial deviator [1]
  N work{};                    ///< plastic, per volume [Pa]
};

/// The root of excess(dp), which falls with dp, in 0 ... high, by Newton's method kept between two ends that
/// hold it; 0 where there is nothing in excess. `first_slope`: about that of its fall [Pa].
template <class Excess>
MPM_INLINE double excess_root(const Excess& excess, double high, double first_slope) {
  double low = 0;
  if (!(excess(0) > 0)) return 0;
  double dp = excess(0) / first_slope;
  for (int k = 0; k < 60; ++k) {
    const double f = excess(dp);
    (f > 0 ? low : high) = dp;
    const double step = 1e-6 * high, slope = (excess(dp + step) - f) / step;
    double next = dp - f / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool done = !(__builtin_fabs(next - dp) > 1e-15 * high);
    dp = next;
    if (done) break;
  }
  return dp;
}

/// One lane at a time: roots take each lane as many turns as it needs. `flow_in(lane)` gives
///   three_g        3 G; 0: there is no strength [Pa]
///   hardened(p)    the stress by the strain alone, for the work over a step, which counts it to the middle
///   [Pa] stress(p, dp)  the yield stress after the increment [Pa]
template <class N, class FlowIn>
MPM_INLINE Returned<N> returned(const N& mises, const N& plastic_strain, const FlowIn& flow_in) {
  using Real = Scalar<N>;
  Returned<N> r;
  for (int lane = 0; lane < Number<N>::width; ++lane) {
    const double q = Number<N>::lane(mises, lane), p = Number<N>::lane(plastic_strain, lane);
    const auto flow = flow_in(lane);
    if (!(flow.three_g > 0)) {  // melted
      Number<N>::set_lane(r.left, lane, 0);
      continue;
    }
    const double dp = excess_root(
        [&](double d) __attribute__((always_inline)) { return q - flow.three_g * d - flow.stress(p, d); },
        q / flow.three_g, flow.three_g);
    if (!(dp > 0)) continue;
    const double end = q - flow.three_g * dp;
    const double before = flow.hardened(p), after = flow.hardened(p + dp);
    Number<N>::set_lane(r.increment, lane, static_cast<Real>(dp));
    Number<N>::set_lane(r.left, lane, static_cast<Real>(end / q));
    const double middle = 0.5 * (1 + (after > 0 ? before / after : 1)) * end;
    Number<N>::set_lane(r.work, lane, static_cast<Real>(dp * middle));
  }
  return r;
}

/// Takes a trial deviator back to the yield surface: new deviator, plastic strain and plastic work.
template <class N, class Tensor, class FlowIn>
MPM_INLINE void take_back(const Tensor& trial, N specific_volume, const FlowIn& flow_in, Tensor& s, N* own) {
  const N mises = Number<N>::square_root(3 * second_invariant(trial));
  const Returned<N> r = returned(mises, own[own_plastic_strain], flow_in);
  s = scaled(r.left, trial);
  own[own_plastic_strain] += r.increment;
  own[own_plastic_work] += r.work * specific_volume;
}

}  // namespace mpm
