#pragma once
/// Bodies become particles.
#include <functional>

#include "libmpm/body/region.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// A region that is filled with material, and how it moves at time 0.
template <int axes>
struct BasicBody {
  BasicRegion<axes> region;
  std::function<Vec<axes>(const Vec<axes>& x)> velocity;  ///< [m/s]
  /// Where the origin of `region` and of `velocity` is [m]. Coordinates that are small near a curved rim keep
  /// more digits there.
  Vec<axes> place = Vec<axes>::Zero();
};
using Body = BasicBody<2>;

/// Nothing yet, on a grid whose lower left corner is `low`, `columns` cells of `cell` (hx, hy) wide and as
/// high as its bodies need. Its left and right sides are mirrors; `floor` says what its lower side is.
/// Throws InputError where the left side is not the axis of an axisymmetric space, x = 0.
State empty_state(Vec2 low, Vec2 cell, int columns, Floor floor = Floor::impact_wall,
                  Space space = Space::plane_strain);
/// Of three axes, `slices` cells deep; front and back are mirrors, too.
BasicState<3> empty_state(Vec3 low, Vec3 cell, int columns, int slices, Floor floor = Floor::impact_wall);

/// Adds the particles of a body, on a square lattice of particles_per_cell, at the density of rest. A
/// particle whose share of the lattice the rim cuts gets the mass and the centroid of what is left of it;
/// shares below a twentieth, of three axes 0.011, are dropped. What lies beyond the sides or the floor of the
/// grid is left out: it is the image of what lies before them. `material`: its number in the scene
/// (material_of()); bodies are filled in the order of their materials. Throws InputError where the region is
/// not bounded, nothing of it lies in the grid, or other particles are there already.
template <int axes>
void fill(BasicState<axes>&, const BasicBody<axes>&, const Scene& materials_and_numerics,
          std::size_t material = 0);

/// The same for all that the region has in rows of cells [first, last), without looking at what is there:
/// density [kg/m^3], particles along the edge of a cell.
template <int axes>
void fill_rows(BasicState<axes>&, const BasicBody<axes>&, double density, int particles_per_edge, int first,
               int last);

/// Of particles_per_cell in cells of so many axes.
int particles_per_edge(const Numerics&, int axes);

}  // namespace mpm
