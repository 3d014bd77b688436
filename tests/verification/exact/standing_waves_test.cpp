// The body forces of the standing waves of three axes and of axial symmetry, by differences as in
// manufactured_test.cpp.
#include "libmpm/verification/exact/standing_waves.hpp"
#include "tests/verification/exact/slope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace {

using namespace mpm::verification::exact;

/// F is diagonal in both.
using Stretches = std::array<double, 3>;

/// dW/dF
Stretches stress_of(const NeoHookean& solid, const Stretches& f) {
  Stretches p{};
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = slope([&](double d) {
      Stretches g = f;
      g[k] += d;
      return solid.strain_energy(g[0] * g[1] * g[2], g[0] * g[0] + g[1] * g[1] + g[2] * g[2] - 3);
    });
  return p;
}

/// dx/dX along an axis.
template <class Waves>
double stretch(const Waves& s, typename Waves::Point x, double t, std::size_t axis) {
  return slope([&](double d) {
    auto at = x;
    at[axis] += d;
    return s.position(at, t)[axis];
  });
}

Stretches stretches(const CubeWaves& s, const CubeWaves::Point& x, double t) {
  return {stretch(s, x, t, 0), stretch(s, x, t, 1), stretch(s, x, t, 2)};
}
/// Along r, z and the hoop.
Stretches stretches(const CylinderWaves& s, const CylinderWaves::Point& x, double t) {
  return {stretch(s, x, t, 0), stretch(s, x, t, 1), s.position(x, t)[0] / x[0]};
}

/// The force of the stress on a unit of volume along an axis, but for that of the hoop.
template <class Waves>
double divergence(const Waves& s, const typename Waves::Point& x, double t, std::size_t axis) {
  return slope([&](double d) {
    auto at = x;
    at[axis] += d;
    return stress_of(s.solid, stretches(s, at, t))[axis];
  });
}

double hoop_force(const CubeWaves&, const CubeWaves::Point&, double, std::size_t) { return 0; }
double hoop_force(const CylinderWaves& s, const CylinderWaves::Point& x, double t, std::size_t axis) {
  const Stretches p = stress_of(s.solid, stretches(s, x, t));
  return axis == 0 ? (p[0] - p[2]) / x[0] : 0;
}

template <class Waves>
void expect_balance(const Waves& s, const typename Waves::Point& x) {
  EXPECT_NEAR(s.position(x, s.period())[0], x[0], 1e-12);
  for (const double t : {0.1, 0.6, 1.9})
    for (std::size_t axis = 0; axis < x.size(); ++axis) {
      const double stress = divergence(s, x, t, axis) + hoop_force(s, x, t, axis);
      const double acceleration = slope([&](double d) { return s.velocity(x, t + d)[axis]; });
      EXPECT_NEAR(acceleration, s.body_force(x, t)[axis] + stress / s.solid.density, 1e-6)
          << axis << ' ' << t;
      EXPECT_NEAR(slope([&](double d) { return s.position(x, t + d)[axis]; }), s.velocity(x, t)[axis], 1e-9);
    }
}

TEST(StandingWaves, ForceBalancesStressAndAcceleration) {
  const NeoHookean solid = NeoHookean::of(2.5, 1.7, 0.3);
  const CubeWaves cube{solid, 0.05};
  expect_balance(cube, {0.3, 0.8, 0.45});
  expect_balance(cube, {0.05, 0.45, 0.9});
  const CylinderWaves cylinder{solid, 0.05};
  expect_balance(cylinder, {0.3, 0.8});
  expect_balance(cylinder, {0.05, 0.45});
}

}  // namespace
