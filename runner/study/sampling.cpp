#include "runner/study/sampling.hpp"

#include <numeric>
#include <utility>

namespace mpmstudy {

std::uint64_t SplitMix64::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double SplitMix64::uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

std::uint64_t SplitMix64::below(std::uint64_t bound) {
  const std::uint64_t uneven = (0 - bound) % bound;  // 2^64 mod bound: the lowest numbers come once too often
  for (;;) {
    const std::uint64_t number = next();
    if (number >= uneven) return number % bound;
  }
}

UnitSamples random_samples(std::uint64_t samples, std::size_t axes, std::uint64_t seed) {
  SplitMix64 random(seed);
  UnitSamples points(samples, std::vector<double>(axes));
  for (auto& point : points)
    for (double& coordinate : point) coordinate = random.uniform();
  return points;
}

UnitSamples latin_hypercube(std::uint64_t samples, std::size_t axes, std::uint64_t seed) {
  SplitMix64 random(seed);
  UnitSamples points(samples, std::vector<double>(axes));
  std::vector<std::uint64_t> strata(samples);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::iota(strata.begin(), strata.end(), std::uint64_t{0});
    for (std::uint64_t i = samples; i > 1; --i) std::swap(strata[i - 1], strata[random.below(i)]);
    for (std::uint64_t i = 0; i < samples; ++i)
      points[i][axis] = (static_cast<double>(strata[i]) + random.uniform()) / static_cast<double>(samples);
  }
  return points;
}

}  // namespace mpmstudy
