#pragma once
/// One thing described twice.
#include <string>
#include <vector>

#include "libmpm/verification/problems/exact_bench.hpp"

namespace mpm::verification {

/// Names of the results of a scene that are not the same bits when all its lengths and times are k times as
/// large, k a power of two; "run" where one of the runs breaks down.
std::vector<std::string> differing_when_scaled(const mpm::Scene&, double k);

/// A block and its mirror image, which meet where the block would meet a mirror or the wall: 200 m/s, 1 ns,
/// while nothing pulls. Largest differences of the block, over the shock's pressure and the impact speed.
struct TwoBodies {
  double mirror_pressure, mirror_velocity;  ///< against a mirror
  double wall_pressure, wall_velocity;      ///< against the wall, ten cells and more away from it
  /// The same two bodies seen from one of them: rms difference of the pressure over its rms, and mean
  /// difference of the velocity.
  double frame_pressure, frame_velocity;
};
TwoBodies two_bodies(const ExactOptions&);

}  // namespace mpm::verification
