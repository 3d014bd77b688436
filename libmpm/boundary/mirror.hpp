#pragma once
/// Walls as mirrors. What lies behind a mirror is the image of the body: nodes behind it hold the image of
/// those before it, and shape functions keep partition of unity and linear reproduction up to the wall.
#include "libmpm/core/grid.hpp"

namespace mpm {

/// Rigid, frictionless, two-sided mirrors at x = origin and x = origin + width: a periodic row of images.
/// Call after p2g, before forces become accelerations. Normal momentum and force on the wall's nodes vanish.
void reflect_sides(Grid&, int top_row);
/// Of three axes the same at z = origin and z = origin + depth.
void reflect_sides(BasicGrid<3>&, int top_row);

/// What the line y = origin is.
enum class Floor {
  impact_wall,  ///< rigid, frictionless, one-sided: see impact_wall.hpp
  mirror,       ///< two-sided: what lies below is the image of what lies above
  open          ///< nothing: a run ends where a body reaches it
};

/// Sides that are not there: a run ends where a body reaches the mirror that stands for one of them.
struct OpenSides {
  bool left = false, right = false, front = false, back = false;
};

/// A mirror along a row of nodes, which both sides of it share: `layers` rows above and below are images of
/// each other. The rows must be there. Call after reflect_sides.
void reflect_row(Grid&, int row, int layers);
void reflect_row(BasicGrid<3>&, int row, int layers);

/// Whether a body gives mass to the nodes of an open side, or of an open floor, up to that row. Call before
/// the mirrors.
bool at_open_face(const Grid&, const OpenSides&, Floor, int top_row);
bool at_open_face(const BasicGrid<3>&, const OpenSides&, Floor, int top_row);

/// A mirror at y = origin.
template <int axes>
void reflect_floor(BasicGrid<axes>& grid) {
  reflect_row(grid, 0, grid.ghosts);
}

}  // namespace mpm
