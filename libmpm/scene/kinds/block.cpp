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

Extent extent(const Scene& s) { return {s.block_width, s.block_height}; }

Lattice lattice(const Scene& s) {
  const bool half = s.numerics.symmetry == Symmetry::half;
  Lattice l;
  // The half width is cut, so that the mirror axis lies on nodes in both descriptions.
  const double half_width = s.block_width / 2;
  const int half_columns = std::max(1, static_cast<int>(std::lround(half_width / s.numerics.cell_size)));
  l.rows = std::max(1, static_cast<int>(std::lround(s.block_height / s.numerics.cell_size)));
  l.cell = Vec2(half_width / half_columns, s.block_height / l.rows);
  l.columns = half ? half_columns : 2 * half_columns;
  l.width = half ? half_width : s.block_width;
  l.empty_rows = 0;
  l.origin = Vec2(half ? 0 : -half_width, 0);
  l.center = Vec2(0, s.cavity_center_height);
  return l;
}

Floor floor(const Scene&) { return Floor::impact_wall; }

double area(const Scene& s, const Lattice& l) { return l.width * s.block_height; }

double fastest(const Scene& s) { return s.impact_speed; }

double shock_pressure(const Scene& s) {
  const Material& m = s.material;
  const double u = s.impact_speed;
  return m.reference_density * shock_speed(m, u) * u;
}

}  // namespace mpm::with_block
