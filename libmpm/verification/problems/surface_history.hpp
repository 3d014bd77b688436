#pragma once
/// The free surface of a block of 10 um on a wall, over the way of all waves.
#include <vector>

#include "libmpm/verification/problems/exact_bench.hpp"

namespace mpm::verification {

/// 0 to 2.6 ns every 5 ps, as in freesurface_history_1d.csv [s].
std::vector<double> history_times();

/// Speed of the free surface against the moving body at history_times() [m/s]; shorter where the run breaks
/// down. 0.05 um cells.
std::vector<double> surface_history(double impact_speed, const ExactOptions&);

/// The same by the one-dimensional Lagrangian code with so many cells.
std::vector<double> reference_history(double impact_speed, int cells);

/// Root mean square differences of two histories, over the largest exact speed.
struct HistoryDistance {
  double whole;  ///< fronts included, which are a few cells wide: falls with the root of the cell
  double late;   ///< after 2.2 ns, when all waves are out
};
HistoryDistance history_distance(const std::vector<double>& ours, const std::vector<double>& exact);

}  // namespace mpm::verification
