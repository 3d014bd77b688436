#pragma once
#include <span>

#include "libmpm/core/grid.hpp"

namespace mpm {

/// Moves points with the material: x += dt v, with v = sum w v_i / sum w over the nodes that carry mass
/// (quadratic B-spline weights). Normalised, since a marker stands at the edge of the material, where some
/// nodes are empty. `grid` holds the nodal motion of the step.
void move_markers(std::span<Vec2> markers, const Grid&, double dt);

}  // namespace mpm
