#pragma once
#include <span>

#include "libmpm/core/grid.hpp"

namespace mpm {

/// Moves points with the material: x += dt v, with v = sum w v_i / sum w over the nodes that carry mass
/// (quadratic B-spline weights). Normalised, since a marker stands at the edge of the material, where some
/// nodes are empty. `grid` holds the nodal motion of the step.
///
/// Nodes lighter than a ten-thousandth of the heaviest one count in proportion to their mass: the force on a
/// node that a particle barely touches says nothing, and a marker that such nodes surround leaves the surface
/// (imploding shell: single markers off by a fifth of the radius). Weighting all nodes by mass would be
/// steady too, but moves markers with the material half a cell inside: 4 % of the stop radius at 20 cells.
/// Checked by tests/verification/imploding_shell_test.cpp.
template <int axes>
void move_markers(std::span<Vec<axes>> markers, const BasicGrid<axes>&, double dt);
/// Rows of nodes that move_markers reads.
template <int axes>
RowRange rows_of(std::span<const Vec<axes>> markers, const BasicGrid<axes>&);

}  // namespace mpm
