#include "runner/study/quasi_random.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <numeric>

namespace mpmstudy {
namespace {

std::vector<std::uint64_t> primes(std::size_t count) {
  std::vector<std::uint64_t> found;
  for (std::uint64_t n = 2; found.size() < count; ++n)
    if (std::ranges::none_of(found, [n](std::uint64_t prime) { return n % prime == 0; })) found.push_back(n);
  return found;
}

}  // namespace

UnitSamples sobol_points(std::uint64_t samples, std::size_t axes, std::uint64_t seed) {
  SplitMix64 random(seed);
  std::vector<std::uint64_t> shift(axes);
  for (auto& bits : shift) bits = random.next();
  UnitSamples points(samples, std::vector<double>(axes));
  boost::random::sobol sobol(axes);
  for (std::uint64_t i = 0; i < samples; ++i)
    for (std::size_t axis = 0; axis < axes; ++axis) {
      // the sequence of Boost leaves out the first point, which is 0
      const std::uint64_t bits = (i == 0 ? 0 : sobol()) ^ shift[axis];
      points[i][axis] = static_cast<double>(bits >> 11) * 0x1p-53;
    }
  return points;
}

UnitSamples halton_points(std::uint64_t samples, std::size_t axes, std::uint64_t seed) {
  UnitSamples points(samples, std::vector<double>(axes));
  const auto bases = primes(axes);
  SplitMix64 random(seed);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::uint64_t base = bases[axis];
    SplitMix64 of_axis(random.next());
    std::vector<std::uint64_t> permutation(base);
    double weight = 1.0 / static_cast<double>(base);
    // every place that a double of [0, 1) has, also those where all indices have the digit 0
    for (std::uint64_t place = 1; weight > 0x1p-53; weight /= static_cast<double>(base)) {
      std::iota(permutation.begin(), permutation.end(), std::uint64_t{0});
      for (std::uint64_t i = base; i > 1; --i) std::swap(permutation[i - 1], permutation[of_axis.below(i)]);
      for (std::uint64_t i = 0; i < samples; ++i)
        points[i][axis] += static_cast<double>(permutation[place == 0 ? 0 : i / place % base]) * weight;
      place = place > samples ? 0 : place * base;  // 0: beyond the last digit of every index
    }
    for (auto& point : points) point[axis] = std::min(point[axis], 1 - 0x1p-53);
  }
  return points;
}

double normal_quantile(double share) {
  const double inside = std::clamp(share, 0x1p-54, 1 - 0x1p-53);
  return -std::sqrt(2.0) * boost::math::erfc_inv(2 * inside);
}

}  // namespace mpmstudy
