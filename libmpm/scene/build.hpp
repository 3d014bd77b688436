#pragma once
#include <vector>

#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// How the modelled part of the scene is cut into cells. Those of a block are stretched by less than half a
/// cell in all so that walls and free surface lie on nodes. A shell stands in a square with two cells to
/// spare, so that neither the right mirror nor, where all of it is modelled, the impact wall ever feels it;
/// of three axes in a cube. Blocks of three axes are as deep as they are wide.
template <int axes>
struct BasicLattice {
  Vec<axes> origin;  ///< lower left corner of the modelled part, of three axes the front one [m]
  Vec<axes> cell;    ///< (hx, hy, hz) [m]
  Vec<axes> center;  ///< of the cavity or of the shell [m]
  double width;      ///< of the modelled part [m]
  int columns;       ///< cells across
  int rows;          ///< cells upwards
  int empty_rows;    ///< of them, the lowest, where no body is
  int slices = 0;    ///< cells along z, of three axes
};
using Lattice = BasicLattice<2>;
template <int axes = 2>
BasicLattice<axes> lattice_of(const Scene&);

/// No body yet, on the scene's lattice and floor.
template <int axes>
BasicState<axes> empty_state_of(const Scene&, const BasicLattice<axes>&);

/// The body at time 0: particles on a square lattice, moving as the kind of scene says. A particle whose
/// share of the lattice a circle cuts gets the mass and the centroid of what is left; small
/// shares are dropped, see body/fill.hpp.
template <int axes = 2>
BasicState<axes> build_state(const Scene&);
MaterialModel build_material(const Scene&);  ///< of `material`
MaterialModels build_materials(const Scene&);
/// A temperature for each material.
std::vector<Temperature> temperatures_of(const Scene&);
/// What is wrong with a body that was made by hand, and with what a scene says of its material, numerics,
/// measures and end.
template <int axes>
std::vector<Problem> find_problems(const Scene&, const BasicState<axes>& body);
/// Of the fastest part of the body [m/s].
double initial_speed(const Scene&);

}  // namespace mpm
