#include "libmpm/verification/problems/free_flight.hpp"

#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <utility>

#include "libmpm/body/fill.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/simulation.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"

namespace mpm::verification {
namespace {

constexpr double flight_cell = 0.2e-6;

/// Of the particles, and of the motion that each carries: the second moment of the quadratic B-spline is
/// h^2/4.
mpm::Vec3 angular_momentum(const mpm::BasicParticles<3>& ps, const mpm::Vec3& center) {
  mpm::Vec3 sum = mpm::Vec3::Zero();
  for (std::size_t p = 0; p < ps.size(); ++p) {
    sum += ps.mass[p] * (ps.position[p] - center).cross(ps.velocity[p]);
    if (ps.affine.empty()) continue;
    const mpm::Mat3& c = ps.affine[p];
    sum += ps.mass[p] * 0.25 * flight_cell * flight_cell *
           mpm::Vec3(c(2, 1) - c(1, 2), c(0, 2) - c(2, 0), c(1, 0) - c(0, 1));
  }
  return sum;
}

}  // namespace

FreeFlight fly_freely(mpm::Transfer transfer) {
  mpm::Scene scene = scenes::in_space(mpm::Space::three_d, scenes::cavity(flight_cell));
  scene.numerics.transfer = transfer;
  scene.numerics.kernel = mpm::Kernel::reference;  // which has all transfers
  // four cells of a cube, as far from every side of the grid
  const mpm::Vec3 low = mpm::Vec3::Constant(4 * flight_cell), high = 2 * low, center = 1.5 * low;
  const mpm::Vec3 spin = 1e8 * mpm::Vec3(0.6, -0.5, 0.7), flight(150, 220, -90);
  auto state = mpm::empty_state(mpm::Vec3::Zero(), mpm::Vec3::Constant(flight_cell), 12, 12);
  mpm::fill<3>(state,
               {mpm::block<3>(low, high),
                [&](const mpm::Vec3& x) { return mpm::Vec3(flight + spin.cross(x - center)); }},
               scene);
  mpm::Simulation3 simulation(scene, std::move(state));
  const mpm::Vec3 momentum = mpm::momentum_of(simulation.state().particles);
  const mpm::Vec3 turning = angular_momentum(simulation.state().particles, center);
  for (int k = 0; k < 200; ++k) simulation.step(5e-12);
  const auto& ps = simulation.state().particles;
  return {(mpm::momentum_of(ps) - momentum).norm() / momentum.norm(),
          (angular_momentum(ps, center) - turning).norm() / turning.norm()};
}

ExactNumbers free_flight_numbers(const ExactOptions&) {
  const FreeFlight affine = fly_freely(mpm::Transfer::apic);
  return {{"momentum error, APIC", "1", 0, affine.momentum_error, 1e-12, Judged::absolute},
          {"angular momentum error, APIC", "1", 0, affine.angular_momentum_error, 1e-12, Judged::absolute}};
}

}  // namespace mpm::verification
