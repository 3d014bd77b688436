#pragma once
#include <utility>
#include <vector>

#include "libmpm/core/archive.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// A closed curve of marker points on the material that bounds the cavity, moved with the grid velocity.
/// In half a scene the markers run over the right half, from the lowest point to the highest; the left half
/// is their image.
class Contour {
 public:
  /// Four markers per cell along the circle. Their polygon has the circle's area exactly.
  Contour(Vec2 center, double radius, double cell_size, bool half);
  /// Of points that are there already, as a section of a surface: counter-clockwise from the lowest, in half
  /// a scene up to the highest.
  Contour(std::vector<Vec2> markers, bool half) : markers_(std::move(markers)), half_(half) {}

  /// See move_markers.
  void advance(const Grid&, double dt);
  /// Rows of nodes that advance reads.
  RowRange rows(const Grid&) const;

  /// True once the curve has crossed itself (a jet has met the far side): its area means nothing from then
  /// on.
  bool crosses_itself() const;
  Vec2 upstream_pole() const { return markers_.front(); }  ///< the marker that started lowest [m]
  Vec2 downstream_pole() const;                            ///< ... and highest [m]
  double area() const;    ///< of the whole cavity [m^2], positive while the curve keeps its sense
  double volume() const;  ///< of the body of revolution of the right half about x = 0 [m^3], as area()
  double width() const;   ///< [m]
  double height() const;  ///< [m]
  Vec2 centroid() const;  ///< of the enclosed area [m]
  void carry(Archive& a) { a.numbers("markers", markers_); }
  /// Area below over area above the chord between the two markers that started at the height of the centre.
  double lower_upper_ratio() const;

 private:
  std::vector<Vec2> closed() const;  ///< all markers of the whole curve, counter-clockwise

  std::vector<Vec2> markers_;
  bool half_;
};

}  // namespace mpm
