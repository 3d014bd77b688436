#pragma once
/// Random points that are the same on every machine and with every standard library.
#include <cstdint>
#include <vector>

namespace mpmstudy {

/// SplitMix64 [Steele, Lea, Flood 2014]: a counter whose bits are mixed. Small, documented, and good enough
/// to place the points of a study.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  double uniform();                          ///< 53 bits in [0, 1)
  std::uint64_t below(std::uint64_t bound);  ///< uniform in [0, bound), without bias; bound > 0
 private:
  std::uint64_t state_;
};

/// Rows of points in the unit cube: result[sample][axis] in [0, 1).
using UnitSamples = std::vector<std::vector<double>>;

/// Independent points, drawn sample after sample: a larger study begins with the points of a smaller one.
UnitSamples random_samples(std::uint64_t samples, std::size_t axes, std::uint64_t seed);

/// Latin hypercube [McKay, Beckman, Conover 1979]: on every axis, each of `samples` equal strata is hit once.
UnitSamples latin_hypercube(std::uint64_t samples, std::size_t axes, std::uint64_t seed);

}  // namespace mpmstudy
