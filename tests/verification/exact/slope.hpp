#pragma once

/// f'(0) to fourth order, by differences over 1e-3, which leave 1e-10 of functions that vary over lengths
/// of 1.
template <class Function>
double slope(const Function& f) {
  constexpr double step = 1e-3;
  return (8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step))) / (12 * step);
}
