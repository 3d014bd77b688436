#pragma once
/// Manufactured solutions: neo-Hookean bodies that body forces drive along a known path.
#include "libmpm/scene/scene.hpp"

namespace mpm::verification {

struct Manufactured {
  mpm::ShapeFunction shape;
  int cells = 16;           ///< to the unit of length
  int side = 2;             ///< particles along each axis of a cell
  double amplitude = 0.05;  ///< A of the solution
  double cfl = 0.4;         ///< share of cell / longitudinal sound speed
  int force_points = 1;     ///< a particle feels the mean of the force over n x n points of its initial share
};

/// The largest root mean square error of the particles' places over one period, over the amplitude; infinite
/// where a particle leaves the grid. E = 1, nu = 0.3, density 1.
double axis_aligned_error(const Manufactured&);    ///< exact/axis_aligned.hpp, pi A of strain
double cube_waves_error(const Manufactured&);      ///< exact/standing_waves.hpp, of three axes
double cylinder_waves_error(const Manufactured&);  ///< ... and in axial symmetry
double vortex_error(const Manufactured&);          ///< exact/vortex.hpp, on a free ring 0.6 < R < 1.4

}  // namespace mpm::verification
