#include "runner/plan/resources.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace mpmstudy {
namespace {

/// Of the program with its catalog, without a job.
constexpr double bytes_of_program = 18e6;
/// Columns of mpm::Particles, which both kernels have, and of their velocity gradients.
constexpr double bytes_of_columns = 200;
/// What the fast step keeps beside them (libmpm/step/PERFORMANCE.md).
constexpr double bytes_of_blocks_double = 186, bytes_of_blocks_float = 100;
/// Of a node, without those of the body: mpm::Node.
constexpr double bytes_of_node = 64;

}  // namespace

double predicted_bytes(const mpm::Scene& scene, const mpm::Estimate& estimate) {
  const auto particles = static_cast<double>(estimate.particles);
  double each = bytes_of_columns;
  if (scene.numerics.kernel == mpm::Kernel::fast)
    each += scene.numerics.precision == mpm::Precision::double_precision ? bytes_of_blocks_double
                                                                         : bytes_of_blocks_float;
  const double nodes = particles / std::max(1, scene.numerics.particles_per_cell);
  return particles * each + nodes * bytes_of_node;
}

Demand demand_of(const std::vector<Job>& jobs, int workers) {
  std::vector<double> bytes;
  for (const Job& job : jobs) bytes.push_back(predicted_bytes(job.scene, job.estimate));
  std::sort(bytes.begin(), bytes.end(), std::greater<>());
  Demand demand{bytes_of_program, wall_seconds(jobs, workers)};
  const auto at_once = std::min(bytes.size(), static_cast<std::size_t>(std::max(workers, 1)));
  for (std::size_t i = 0; i < at_once; ++i) demand.bytes += bytes[i];
  return demand;
}

}  // namespace mpmstudy
