#pragma once
/// Points that fill the unit cube more evenly than random ones. A larger set begins with the points of a
/// smaller one, and the same seed gives the same points on every machine. Sobol numbers and the quantile of
/// the normal distribution are those of Boost, which nothing else includes.
#include <cstdint>

#include "runner/study/sampling.hpp"

namespace mpmstudy {

/// The Sobol sequence with the direction numbers of [Joe, Kuo 2008], shifted digit by digit: the 53 bits of
/// every coordinate are XORed with random ones of its axis. Of the first 2^m points, each of 2^m equal strata
/// of every axis has one, as without the shift. At most most_sobol_axes.
UnitSamples sobol_points(std::uint64_t samples, std::size_t axes, std::uint64_t seed);
inline constexpr std::size_t most_sobol_axes = 3667;

/// The Halton sequence whose digits are permuted, each place of each axis by a random permutation of its own
/// [Owen, A randomized Halton algorithm in R, 2017]: axes with large bases are not correlated as in the plain
/// one.
UnitSamples halton_points(std::uint64_t samples, std::size_t axes, std::uint64_t seed);

/// The number below which that share of the standard normal distribution lies; shares of 0 and 1 are taken a
/// step inside, where it is finite (-8.3, 8.2).
double normal_quantile(double share);

}  // namespace mpmstudy
