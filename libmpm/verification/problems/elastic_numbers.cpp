#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "libmpm/verification/problems/elastic_bodies.hpp"
#include "libmpm/verification/problems/manufactured.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/with_options.hpp"

namespace mpm::verification {
namespace {

/// Errors on ever finer cells, the order between each two, and how far down the second order goes. It counts
/// as kept while an order is at least 1.8, and should go down to `aim`. `force_points`: see Manufactured.
ExactNumbers convergence(double (*error_of)(const Manufactured&), int force_points, double aim,
                         const std::vector<int>& cells, const BodyScheme& scheme,
                         const ExactOptions& options) {
  constexpr double kept = 1.8;
  ExactNumbers orders;
  double last = 0, reached = 0;
  bool goes_on = true;
  std::string last_name;
  for (const int n : cells) {
    const int used = std::max(4, static_cast<int>(std::lround(n / options.cells)));
    const std::string name = std::to_string(used);
    const double error =
        error_of({.shape = scheme.shape, .cells = used, .side = scheme.side, .force_points = force_points});
    if (last_name.empty()) {
      reached = error;
    } else {
      const double order = std::log2(last / error);
      orders.push_back(
          {"order, " + last_name + " to " + name + " cells", "1", 2, order, 2 - kept, Judged::shortfall});
      goes_on = goes_on && order >= kept;
      if (goes_on) reached = error;
    }
    last = error, last_name = name;
  }
  orders.push_back({"error to which the order is 1.8", "1", 0, reached, aim, Judged::absolute});
  return orders;
}

int cells_of(int cells, const ExactOptions& options) {
  return std::max(20, 4 * static_cast<int>(std::lround(cells / options.cells / 4)));
}

}  // namespace

ExactNumbers axis_aligned_numbers(const ExactOptions& options) {
  return convergence(axis_aligned_error, 1, 1e-3, {16, 32, 64, 128}, body_scheme(options), options);
}

namespace {

/// The scheme of planar impacts, whose domains tile the body at 16 % strain; see convergence_test.cpp.
BodyScheme tiling(const ExactOptions& options) {
  return {options.scheme.value_or(mpm::ShapeFunction::gimp), body_scheme(options).side};
}

}  // namespace

ExactNumbers cylinder_waves_numbers(const ExactOptions& options) {
  return convergence(cylinder_waves_error, 1, 5e-3, {16, 32, 64}, tiling(options), options);
}

ExactNumbers cube_waves_numbers(const ExactOptions& options) {
  return convergence(cube_waves_error, 1, 5e-3, {12, 24, 48}, tiling(options), options);
}

/// The force jumps at the edges of the turning rings: a sample at the particle alone would be an error of the
/// problem that is posed, not of the scheme.
ExactNumbers vortex_numbers(const ExactOptions& options) {
  return convergence(vortex_error, 4, 1e-3, {16, 32, 64}, body_scheme(options), options);
}

ExactNumbers vibrating_bar_numbers(const ExactOptions& options) {
  const BodyScheme scheme = body_scheme(options);
  const BarMotion motion = vibrate(scheme.shape, cells_of(50, options), scheme.side);
  return {{"frequency", "rad/s", vibrating_bar.frequency(), motion.frequency, 0.001},
          {"rms error of the mean velocity", "1", 0, motion.velocity_error, 0.01, Judged::absolute}};
}

ExactNumbers elastic_disks_numbers(const ExactOptions& options) {
  const BodyScheme scheme = body_scheme(options);
  const Collision c = collide(scheme.shape, cells_of(80, options), scheme.side);
  return {{"momentum error", "1", 0, c.momentum_error, 1e-12, Judged::absolute},
          {"energy error, heat included", "1", 0, c.energy_error, 1e-12, Judged::absolute},
          {"elastic and kinetic energy lost", "1", 0, c.loss, 0.03, Judged::absolute},
          {"rebound over approach", "1", 1, c.rebound, 0.05},
          {"least kinetic energy (they met)", "1", 0, c.least_kinetic, 0.05, Judged::absolute}};
}

}  // namespace mpm::verification
