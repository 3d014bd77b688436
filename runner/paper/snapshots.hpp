#pragma once
/// What claims ask of snapshots.
#include <cstddef>
#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"

namespace mpmstudy {

/// Where plastic work is largest in a snapshot.
struct HotSpot {
  double time = 0;      ///< [s]
  double x = 0, y = 0;  ///< mass centre of the hottest thousandth [m]; x of the right half
  /// Of the material around it, out to half of its distance to the axis [rad/s], counter-clockwise: angular
  /// momentum about the mass centre over moment of inertia.
  double rotation = 0;
};

/// Closed empty regions of a snapshot, both halves of the block, each of a cell or more.
struct Cavities {
  double time = 0;  ///< [s]
  std::ptrdiff_t count = 0;
  double largest = 0, total = 0;  ///< [m^2]
};

/// Of the study's first done job, one per snapshot, in order of time.
std::vector<HotSpot> hot_spots_of(const Evidence&, const std::string& study);
std::vector<Cavities> cavities_of(const Evidence&, const std::string& study);

}  // namespace mpmstudy
