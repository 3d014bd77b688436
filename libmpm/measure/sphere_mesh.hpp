#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "libmpm/core/tensor.hpp"

namespace mpm {

/// What is meshed of a sphere: all of it, or what lies at x, z >= 0, or at x, y, z >= 0.
enum class SpherePart { whole, quarter, octant };

/// Points of the sphere of radius 1 about the origin, and triangles between them: those of an octahedron,
/// each edge cut into equal angles. Points on the planes between octants are shared, and lie on them to the
/// last bit.
struct SphereMesh {
  using Triangle = std::array<int, 3>;

  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< counter-clockwise, seen from outside
  /// The points with z = 0, then those with x = 0: counter-clockwise in (x, y) and in (z, y) from the lowest,
  /// all around or, in a quarter, up to the highest. None in an octant.
  std::array<std::vector<int>, 2> meridians;

  /// Of each point, in the area of the triangles: a third of those around it.
  std::vector<double> shares() const;
};
/// `steps`: edges to a right angle.
SphereMesh sphere_mesh(SpherePart, int steps);

}  // namespace mpm
