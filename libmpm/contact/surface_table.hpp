#pragma once
#include <vector>

#include "libmpm/shape/gimp.hpp"
#include "libmpm/shape/shape.hpp"

namespace mpm {

/// Where the surface of a body lies that a node sees part of.
///
/// Of a body that fills the half line up to s (in cells, the node at 0) the node sees, by its shape function,
/// the centroid
///   D(s) = sum w(x_p) x_p / sum w(x_p)        [cells]
/// of the particles at x_p = s - l, s - 3 l, ... with l their half size. D grows with s; the table is its
/// inverse s(D). It is made once, for a shape function and a number of particles per edge, by sliding the
/// edge of such a body past a node. This is the calibration of the gap that J. A. Nairn (Contact in MPM,
/// chapters 3.6 and 4.1) does for linear shape functions by a power law. D needs neither the density of the
/// body nor that of its particles; projected on the normal it serves for surfaces of any direction, since the
/// spread of a product of shape functions is the same along all of them.
/// Checked by tests/libmpm/contact_test.cpp.
class SurfaceTable {
 public:
  /// The shape function, and the half size of a particle at rest [cells]. Cpdi is close to Gimp.
  template <class Shape>
  static SurfaceTable of(double half) {
    if constexpr (!ProductShape<Shape>)
      return of<Gimp>(half);
    else
      return SurfaceTable(half, [half](double x) {
        constexpr int node = 8;
        const auto w = Shape::evaluate(node + x, half);
        const int k = node - w.first;
        return k >= 0 && k < w.nodes ? w.value[static_cast<std::size_t>(k)] : 0.0;
      });
  }
  /// s(D) [cells]. What fills all that the node sees has its surface at the edge of that.
  double surface(double centroid) const;

 private:
  template <class Weight>
  SurfaceTable(double half, Weight weight) {
    constexpr double edge = 2, step = 0.01;  // no shape function reaches further
    constexpr double almost_all = 0.998, next_to_nothing = 1e-6;
    for (double s = -edge; s <= edge; s += step) {
      double sum = 0, moment = 0;
      for (double x = s - half; x > -edge; x -= 2 * half) sum += weight(x), moment += weight(x) * x;
      const double share = 2 * half * sum;
      if (share < next_to_nothing) continue;
      if (share > almost_all) break;
      add(moment / sum, s);
    }
  }
  void add(double centroid, double surface);

  std::vector<double> centroids_, surfaces_;  ///< ascending
};

}  // namespace mpm
