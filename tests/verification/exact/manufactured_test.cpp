// The body forces of the manufactured solutions: what moves the solid along its path is the force and the
// divergence of its stress, and the stress is the slope of its strain energy. Both slopes by differences
// here.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "libmpm/verification/exact/axis_aligned.hpp"
#include "libmpm/verification/exact/vibrating_bar.hpp"
#include "libmpm/verification/exact/vortex.hpp"
#include "tests/verification/exact/slope.hpp"

namespace {

using namespace mpm::verification::exact;
using Gradient = std::array<double, 4>;  ///< xx, xy, yx, yy

template <class Solution>
Gradient deformation(const Solution& s, Vector x, double t) {
  const auto along_x = [&](double d) { return s.position({x.x + d, x.y}, t); };
  const auto along_y = [&](double d) { return s.position({x.x, x.y + d}, t); };
  return {slope([&](double d) { return along_x(d).x; }), slope([&](double d) { return along_y(d).x; }),
          slope([&](double d) { return along_x(d).y; }), slope([&](double d) { return along_y(d).y; })};
}

/// dW/dF
Gradient stress(const NeoHookean& solid, const Gradient& f) {
  Gradient p{};
  for (std::size_t k = 0; k < 4; ++k)
    p[k] = slope([&](double d) {
      Gradient g = f;
      g[k] += d;
      return solid.strain_energy(g[0], g[1], g[2], g[3]);
    });
  return p;
}

template <class Solution>
void expect_balance(const Solution& s, Vector x, double t) {
  const auto p = [&](double dx, double dy) {
    return stress(s.solid, deformation(s, {x.x + dx, x.y + dy}, t));
  };
  const auto divergence = [&](std::size_t row) {
    return slope([&](double d) { return p(d, 0)[2 * row]; }) +
           slope([&](double d) { return p(0, d)[2 * row + 1]; });
  };
  const Vector force = s.body_force(x, t);
  const double rho = s.solid.density;
  EXPECT_NEAR(slope([&](double d) { return s.velocity(x, t + d).x; }), force.x + divergence(0) / rho, 1e-6);
  EXPECT_NEAR(slope([&](double d) { return s.velocity(x, t + d).y; }), force.y + divergence(1) / rho, 1e-6);
  EXPECT_NEAR(slope([&](double d) { return s.position(x, t + d).x; }), s.velocity(x, t).x, 1e-9);
  EXPECT_NEAR(slope([&](double d) { return s.position(x, t + d).y; }), s.velocity(x, t).y, 1e-9);
}

TEST(AxisAligned, ForceBalancesStressAndAcceleration) {
  const AxisAligned s{NeoHookean::of(2.5, 1.7, 0.3), 0.05};
  EXPECT_NEAR(s.position({0.3, 0.8}, s.period()).x, 0.3, 1e-12);
  for (const double t : {0.1, 0.6, 1.9}) {
    expect_balance(s, {0.3, 0.8}, t);
    expect_balance(s, {0.05, 0.45}, t);
  }
}

TEST(Vortex, ForceBalancesStressAndAcceleration) {
  const Vortex s{NeoHookean::of(2.5, 1.7, 0.3), 0.3, 1.3};
  EXPECT_NEAR(s.position({0.3, 0.9}, 1.3).x, 0.3, 1e-12);
  for (const double t : {0.1, 0.6, 1.2}) {
    expect_balance(s, {0.9, 0.2}, t);
    expect_balance(s, {-0.4, 1.05}, t);
    expect_balance(s, {0.1, -0.6}, t);  // nothing moves
  }
}

// J = 1 all along.
TEST(Vortex, TurnsWithoutChangeOfVolume) {
  const Vortex s{NeoHookean::of(1, 1, 0.3), 0.5};
  const Gradient f = deformation(s, {0.8, -0.5}, 0.4);
  EXPECT_NEAR(f[0] * f[3] - f[1] * f[2], 1, 1e-8);
}

TEST(NeoHookean, SmallStrainsAreHookes) {
  const NeoHookean solid = NeoHookean::of(1, 3, 0.25);
  EXPECT_NEAR(solid.youngs_modulus(), 3, 1e-12);
  const double e = 1e-3;  // W = (lambda/2 + mu) e^2 of a uniaxial strain, mu e^2/2 of a shear
  EXPECT_NEAR(solid.strain_energy(1 + e, 0, 0, 1) / (e * e), solid.lambda / 2 + solid.mu, 0.01);
  EXPECT_NEAR(solid.strain_energy(1, e, 0, 1) / (e * e), solid.mu / 2, 0.001);
}

// Numbers of the reference: L = 25, E = 100, rho = 1, v0 = 0.1.
TEST(VibratingBar, FirstMode) {
  constexpr VibratingBar bar{25, 100, 1, 0.1};
  EXPECT_NEAR(bar.period(), 10, 1e-12);
  EXPECT_NEAR(bar.mean_velocity(0), 0.0636620, 1e-7);
  EXPECT_NEAR(bar.largest_mean_velocity() / bar.frequency(), 0.101321, 1e-6);
  EXPECT_NEAR(bar.initial_velocity(25), 0.1, 1e-15);
}

}  // namespace
