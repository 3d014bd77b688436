#include "analysis/student_t.hpp"

#include <cmath>
#include <numbers>

namespace analysis {
namespace {

/// P(|T| < t) in closed form for whole degrees of freedom [Abramowitz & Stegun 26.7.3, 26.7.4]; theta =
/// atan(t/sqrt(n)).
double coverage(double t, int n) {
  if (n <= 0) return std::erf(t / std::numbers::sqrt2);
  const double theta = std::atan(t / std::sqrt(static_cast<double>(n)));
  const double c2 = std::cos(theta) * std::cos(theta);
  double sum = 0, term = n % 2 == 0 ? 1 : std::cos(theta);
  for (int k = n % 2 == 0 ? 0 : 1; k <= n - 2; k += 2) {
    sum += term;
    term *= c2 * (k + 1) / (k + 2);
  }
  if (n % 2 == 0) return std::sin(theta) * sum;
  return 2 / std::numbers::pi * (theta + std::sin(theta) * sum);
}

}  // namespace

double student_t_two_sided(double probability, int degrees_of_freedom) {
  double low = 0, high = 1;
  while (coverage(high, degrees_of_freedom) < probability && high < 1e15) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double middle = (low + high) / 2;
    (coverage(middle, degrees_of_freedom) < probability ? low : high) = middle;
  }
  return high;
}

}  // namespace analysis
