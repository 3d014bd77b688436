#pragma once
#include <limits>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "libmpm/verification/lagrangian/lagrangian_2d.hpp"

namespace mpm::verification::lagrangian {

/// What the Lagrangian code makes of a scene of the kind cavity-impact, on one mesh.
struct Collapse {
  int cells = 0;              ///< to the cavity's radius
  std::vector<double> time;   ///< [s], a hundred times and the start
  std::vector<double> area;   ///< open area of the whole cavity then, the polygon of its rim [m^2]
  double collapsibility = 0;  ///< 1 - mean area over the last quarter of the run / initial area; NaN: stopped
  double energy_error = 0;    ///< largest relative change of the energy
  std::string stopped = {};   ///< why the mesh does not reach the end; empty where it does
  double stop_time = std::numeric_limits<double>::infinity();  ///< when [s]

  /// Between the samples by a straight line; NaN after the stop [m^2].
  double area_at(double time) const;
};

/// `cells` to the radius, times `times`: see cavity_mesh(). Takes a block with one cavity that falls onto a
/// wall (cavity-impact). Throws std::invalid_argument for another scene or space, and where the cavity
/// touches a side of the block: the code has no contact of faces, and stops where those of the cavity meet.
Collapse collapse(const mpm::Scene&, int cells, int times = 1, const Lagrangian2d::Options& = {});

/// A number that meshes of 1/n, 2/n, 4/n the size give, of the finest the last.
struct Limit {
  double extrapolated;  ///< at mesh size 0, with the observed order; NaN where there is none
  double order;         ///< log2 of the ratio of the differences; NaN where they change sign
};
Limit limit_of(double coarse, double middle, double fine);

/// The same scene on three meshes, each twice as fine as the one before.
struct CollapseLadder {
  std::vector<Collapse> meshes;
  Limit collapsibility;
};
CollapseLadder collapse_ladder(const mpm::Scene&, int coarsest_cells, const Lagrangian2d::Options& = {});

}  // namespace mpm::verification::lagrangian
