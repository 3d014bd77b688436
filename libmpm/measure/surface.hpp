#pragma once
#include <cstddef>
#include <vector>

#include "libmpm/measure/contour.hpp"
#include "libmpm/measure/sphere_mesh.hpp"

namespace mpm {

/// The surface of a cavity of three axes: markers on the material that bounds it, moved with the grid
/// velocity, and the triangles between them. Of a symmetric scene the quarter at x, z >= 0.
///
/// Two markers per cell. At the start the volume is that of the sphere, and the section has its area to
/// (h / R)^2 / 10.
class Surface {
 public:
  Surface(const Vec3& center, double radius, double cell_size, bool quarter);

  /// See move_markers.
  void advance(const BasicGrid<3>&, double dt);
  /// Rows of nodes that advance reads.
  RowRange rows(const BasicGrid<3>&) const;

  /// Whether one of the two meridians that began in the planes of symmetry has crossed itself, or, in a
  /// quarter, any marker its mirror. What crosses elsewhere is not seen: a jet along the axis meets the far
  /// side on both.
  bool crosses_itself() const;
  Vec3 upstream_pole() const {
    return at(mesh_.meridians[0].front());
  }                              ///< the marker that started lowest [m]
  Vec3 downstream_pole() const;  ///< ... and highest [m]
  double volume() const;         ///< of the whole cavity [m^3], positive while the surface keeps its sense
  /// The markers that began at z = 0, which in a symmetric scene is where they stay.
  Contour section() const { return meridian(0); }
  void carry(Archive& a) { a.numbers("markers", markers_); }

 private:
  const Vec3& at(int marker) const { return markers_[static_cast<std::size_t>(marker)]; }
  Contour meridian(std::size_t which) const;

  bool quarter_;
  SphereMesh mesh_;  ///< its triangles and meridians
  std::vector<Vec3> markers_;
};

}  // namespace mpm
