#include "runner/plan/resources.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "libmpm/core/grid.hpp"

namespace mpmstudy {
namespace {

/// Of the program with its catalog, without a job.
constexpr double bytes_of_program = 18e6;
/// What a run keeps of a particle and of a node [bytes]. Measured where it is more than a sum of columns: see
/// libmpm/step/PERFORMANCE.md.
struct Bytes {
  double columns;  ///< of mpm::BasicParticles, which both kernels have, and of their velocity gradients
  double blocks_double, blocks_float;  ///< what the fast step keeps beside them, with its nodes
  double node;                         ///< mpm::BasicNode
};
constexpr Bytes of_two_axes{200, 186, 100, sizeof(mpm::BasicNode<2>)};
constexpr Bytes of_three_axes{270, 221, 134, sizeof(mpm::BasicNode<3>)};

}  // namespace

double predicted_bytes(const mpm::Scene& scene, const mpm::Estimate& estimate) {
  const auto particles = static_cast<double>(estimate.particles);
  const Bytes& bytes = mpm::axes_of(scene.space) == 3 ? of_three_axes : of_two_axes;
  double each = bytes.columns;
  if (scene.numerics.kernel == mpm::Kernel::fast)
    each += scene.numerics.precision == mpm::Precision::double_precision ? bytes.blocks_double
                                                                         : bytes.blocks_float;
  const double nodes = particles / std::max(1, scene.numerics.particles_per_cell);
  return particles * each + nodes * bytes.node;
}

Demand demand_of(const std::vector<Job>& jobs, int workers) {
  std::vector<double> bytes;
  for (const Job& job : jobs) bytes.push_back(predicted_bytes(job.scene, job.estimate));
  std::sort(bytes.begin(), bytes.end(), std::greater<>());
  Demand demand{bytes_of_program, wall_seconds(jobs, workers), bytes.empty() ? 0 : bytes.front()};
  const auto at_once = std::min(bytes.size(), static_cast<std::size_t>(std::max(workers, 1)));
  for (std::size_t i = 0; i < at_once; ++i) demand.bytes += bytes[i];
  return demand;
}

}  // namespace mpmstudy
