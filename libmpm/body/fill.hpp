#pragma once
/// Bodies become particles.
#include <functional>

#include "libmpm/body/region.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// A region that is filled with material, and how it moves at time 0.
struct Body {
  Region region;
  std::function<Vec2(const Vec2& x)> velocity;  ///< [m/s]
  /// Where the origin of `region` and of `velocity` is [m]. Coordinates that are small near a curved rim keep
  /// more digits there.
  Vec2 place = Vec2::Zero();
};

/// Nothing yet, on a grid whose lower left corner is `low`, `columns` cells of `cell` (hx, hy) wide and as
/// high as its bodies need. Its left and right sides are mirrors; `floor` says what its lower side is.
/// Throws InputError where the left side is not the axis of an axisymmetric space, x = 0.
State empty_state(Vec2 low, Vec2 cell, int columns, Floor floor = Floor::impact_wall,
                  Space space = Space::plane_strain);

/// Adds the particles of a body, on a square lattice of particles_per_cell, at the density of rest. A
/// particle whose share of the lattice the rim cuts gets the mass and the centroid of what is left of it;
/// shares below a twentieth are dropped. What lies beyond the sides or the floor of the grid is left out: it
/// is the image of what lies before them. Throws InputError where the region is not bounded, nothing of it
/// lies in the grid, or other particles are there already.
void fill(State&, const Body&, const Scene& material_and_numerics);

/// The same for all that the region has in rows of cells [first, last), without looking at what is there:
/// density [kg/m^3], particles along the edge of a cell.
void fill_rows(State&, const Body&, double density, int particles_per_edge, int first, int last);

}  // namespace mpm
