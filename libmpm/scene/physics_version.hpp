#pragma once
#include <algorithm>

#include "libmpm/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Raised with every change of the bits that the plain step alone gives (kernel = "reference"). Where both
/// kernels change, physics_version is raised above it.
inline constexpr int reference_physics_version = 6;

/// What the key of a scene begins with: a result is found again only by a program that would make the same
/// bits.
inline int physics_version_of(const Scene& s) {
  return s.numerics.kernel == Kernel::reference ? std::max(reference_physics_version, physics_version)
                                                : physics_version;
}

}  // namespace mpm
