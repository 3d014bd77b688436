#pragma once
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// How the modelled part of the block is cut into cells. Cells are stretched by less than half a cell in all
/// so that walls and free surface lie on nodes.
struct Lattice {
  Vec2 origin;   ///< lower left corner of the modelled part [m]
  Vec2 cell;     ///< (hx, hy) [m]
  double width;  ///< of the modelled part [m]
  int columns;   ///< cells across
  int rows;      ///< cells of the block, upwards
};
Lattice lattice_of(const Scene&);

/// The body at time 0: particles on a square lattice, moving at -impact_speed. A particle whose share of the
/// lattice the cavity cuts gets the mass and the centroid of what is left; shares below a twentieth are
/// dropped.
State build_state(const Scene&);
MaterialModel build_material(const Scene&);

}  // namespace mpm
