// Three ways to say one scene, while nothing pulls: a block on a wall, two blocks that meet, and the same two
// seen by an observer who moves.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/measure/energy.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/step/step.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

constexpr double cell = 0.1e-6, height = 10e-6, speed = 200, dt = 4e-12;
constexpr int steps = 250;  // 1 ns: the shock has gone half the way

mpm::Scene block() { return scenes::planar(speed, height, cell, 1e-9); }

/// The block of the scene, and its mirror image below the line y = `contact`. All at `drift` more.
mpm::State two_blocks(double contact, double drift) {
  mpm::State s = mpm::build_state(block());
  mpm::Particles& ps = s.particles;
  const std::size_t n = ps.size();
  for (std::size_t p = 0; p < n; ++p) {
    const mpm::Vec2 x = ps.position[p], v = ps.velocity[p];
    ps.position[p].y() = contact + x.y();
    ps.velocity[p].y() = v.y() + drift;
    ps.add({x.x(), contact - x.y()}, {v.x(), -v.y() + drift}, ps.mass[p], ps.initial_volume[p],
           ps.half_size[p]);
  }
  s.velocity_gradient.assign(ps.size(), mpm::Mat2::Zero());
  return s;
}

void advance(mpm::State& s) {
  const mpm::MaterialModel material = mpm::build_material(block());
  for (int k = 0; k < steps; ++k) mpm::reference_step<mpm::Gimp>(s, material, dt);
}

// To rounding, before anything is in tension: the mirror is the other body.
TEST(TwoBodies, AreTheBlockOnAMirror) {
  mpm::State one = mpm::build_state(block()), two = two_blocks(200 * cell, 0);
  one.floor = mpm::Floor::mirror;
  advance(one);
  advance(two);
  const std::size_t n = one.particles.size();
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_NEAR(two.particles.pressure[p], one.particles.pressure[p], 1e-9 * 3e9);
    EXPECT_NEAR(two.particles.velocity[p].y(), one.particles.velocity[p].y(), 1e-9 * speed);
    EXPECT_NEAR(two.particles.velocity[n + p].y(), -one.particles.velocity[p].y(), 1e-9 * speed);
  }
}

// The wall takes the approach of what touches it, which two bodies in one grid keep in their first particles:
// the difference stays there.
TEST(TwoBodies, AreTheBlockOnTheWallAwayFromIt) {
  mpm::State one = mpm::build_state(block()), two = two_blocks(200 * cell, 0);
  advance(one);
  advance(two);
  for (std::size_t p = 0; p < one.particles.size(); ++p) {
    if (one.particles.position[p].y() < 10 * cell) continue;
    EXPECT_NEAR(two.particles.pressure[p], one.particles.pressure[p], 0.01 * 3e9);
    EXPECT_NEAR(two.particles.velocity[p].y(), one.particles.velocity[p].y(), 0.01 * speed);
  }
}

// The grid stands still, so a body that drifts through it crosses cells: the same to its quadrature error.
TEST(TwoBodies, LookTheSameToAMovingObserver) {
  mpm::State at_rest = two_blocks(200 * cell, 0), moving = two_blocks(200 * cell, speed);
  advance(at_rest);
  advance(moving);
  const std::size_t n = at_rest.particles.size() / 2;
  double square = 0, scale = 0, drift = 0;
  for (std::size_t p = 0; p < n; ++p) {
    square += std::pow(moving.particles.pressure[p] - at_rest.particles.pressure[p], 2);
    scale += std::pow(at_rest.particles.pressure[p], 2);
    drift += moving.particles.velocity[p].y() - speed - at_rest.particles.velocity[p].y();
  }
  EXPECT_LT(std::sqrt(square / scale), 0.01);
  EXPECT_LT(std::abs(drift / static_cast<double>(n)), 0.001 * speed);
}

}  // namespace
