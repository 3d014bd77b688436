#pragma once
#include <cmath>

namespace mpm::verification::exact {

/// The argument in [low, high] where a rising function changes its sign, to the last bit: bisection until no
/// number lies between. Where f has no zero in the bracket, the end that is nearest to one.
template <class Function>
double bisect(const Function& f, double low, double high) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) return high;
    (f(middle) < 0 ? low : high) = middle;
  }
}

}  // namespace mpm::verification::exact
