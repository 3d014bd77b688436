#include "libmpm/scene/kinds/block.hpp"

#include <algorithm>
#include <cmath>

namespace mpm::with_block {

void check(const Scene& s, Report& report) {
  report.require(s.numerics.cell_size <= s.block_width / 8, "cell_size",
                 "at most an eighth of block_width (" + text_of(s.block_width / 8) + " m)");
  report.require(s.numerics.cell_size <= s.block_height / 4, "cell_size",
                 "at most a quarter of block_height (" + text_of(s.block_height / 4) + " m)");
}

Extent extent(const Scene& s) { return {s.block_width, s.block_height, s.block_width}; }

namespace {

Vec2 in_plane(double across, double up, Vec2) { return {across, up}; }
Vec3 in_plane(double across, double up, Vec3) { return {across, up, across}; }

}  // namespace

template <int axes>
BasicLattice<axes> lattice(const Scene& s) {
  const bool half = s.numerics.symmetry == Symmetry::half;
  const auto vector = [](double across, double up) { return in_plane(across, up, Vec<axes>()); };
  BasicLattice<axes> l;
  // The half width is cut, so that the mirror axis lies on nodes in both descriptions.
  const double half_width = s.block_width / 2;
  const int half_columns = std::max(1, static_cast<int>(std::lround(half_width / s.numerics.cell_size)));
  l.rows = std::max(1, static_cast<int>(std::lround(s.block_height / s.numerics.cell_size)));
  l.cell = vector(half_width / half_columns, s.block_height / l.rows);
  l.columns = half ? half_columns : 2 * half_columns;
  l.width = half ? half_width : s.block_width;
  if (axes == 3) l.slices = l.columns;
  l.empty_rows = 0;
  l.origin = vector(half ? 0 : -half_width, 0);
  l.center = vector(0, s.cavity_center_height);
  return l;
}

Floor floor(const Scene&) { return Floor::impact_wall; }

template <int axes>
double size(const Scene& s, const BasicLattice<axes>& l) {
  return l.width * s.block_height * (axes == 2 ? 1 : l.width);
}

double fastest(const Scene& s) { return s.impact_speed; }

double shock_pressure(const Scene& s) {
  const Material& m = s.material;
  const double u = s.impact_speed;
  return m.reference_density * shock_speed(m, u) * u;
}

template Lattice lattice(const Scene&);
template BasicLattice<3> lattice(const Scene&);
template double size(const Scene&, const Lattice&);
template double size(const Scene&, const BasicLattice<3>&);

}  // namespace mpm::with_block
