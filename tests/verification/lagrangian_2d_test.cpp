// The two-dimensional Lagrangian code against exact answers, and what it needs to be a reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "libmpm/verification/exact/elastic_plastic_impact.hpp"
#include "libmpm/verification/exact/lagrangian_1d.hpp"
#include "libmpm/verification/lagrangian/collapse.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using namespace mpm::verification::lagrangian;
namespace exact = mpm::verification::exact;
using mpm::Vec2;

const mpm::Material aluminium = mpm::named_material("aluminium");

/// Middle part of the plateau behind the wave that a wall sends into a block, relative to the exact state.
struct Plateau {
  double normal_stress, von_mises, energy;
};
Plateau plateau(double speed, int rows, const Lagrangian2d::Options& options = {}) {
  const double height = 20e-6;
  const exact::ImpactState state = exact::elastic_plastic_impact(scenes::exact_solid(aluminium), speed);
  QuadMesh mesh = block_mesh(4 * height / rows, height, 4, rows);
  std::vector<Vec2> velocities(mesh.nodes.size(), Vec2(0, -speed));
  Lagrangian2d code(aluminium, std::move(mesh), std::move(velocities), options);
  const double energy = code.energy(), end = 0.8 * height / state.plastic_wave_speed;
  while (code.time() < end)
    if (!code.advance(end - code.time())) return {NAN, NAN, NAN};
  double normal = 0, mises = 0, count = 0;
  for (std::size_t i = 0; i < code.mesh().cells.size(); ++i) {
    const double y = (static_cast<double>(i / 4) + 0.5) / rows;
    if (y < 0.15 || y > 0.5) continue;
    normal += code.pressure(i) - code.deviator(i).yy;
    mises += std::sqrt(3 * mpm::second_invariant(code.deviator(i)));
    ++count;
  }
  return {normal / count / state.normal_stress - 1, mises / count / state.von_mises - 1,
          code.energy() / energy - 1};
}

TEST(Lagrangian2d, MeetsTheStateBehindAPlaneShock) {
  for (const double speed : {200.0, 1120.0}) {
    const Plateau p = plateau(speed, 200);
    EXPECT_NEAR(p.normal_stress, 0, 1e-4) << speed;
    EXPECT_NEAR(p.von_mises, 0, 0.006) << speed;
    EXPECT_NEAR(p.energy, 0, 1e-13) << speed;
  }
}

// Without hourglass control, rounding grows behind a strong shock until the mesh turns over.
TEST(Lagrangian2d, HourglassMotionIsHeldBehindAStrongShock) {
  EXPECT_TRUE(std::isnan(plateau(1120, 400, {.hourglass = 0}).normal_stress));
  EXPECT_NEAR(plateau(1120, 400).normal_stress, 0, 1e-4);
}

TEST(Lagrangian2d, StopsShellsWhereTheOneDimensionalCodeDoes) {
  mpm::Material material = aluminium;
  material.hardening_modulus = 0;
  const double inner = 1.5e-6, outer = 3e-6;
  for (const double speed : {131.0531, 185.0293}) {
    QuadMesh mesh = ring_mesh(inner, outer, 36, 24);
    std::vector<Vec2> velocities;
    for (const Vec2& x : mesh.nodes) velocities.push_back(-speed * inner / x.squaredNorm() * x);
    Lagrangian2d code(material, std::move(mesh), std::move(velocities), {});
    const auto radius = [&](int node) { return code.positions()[static_cast<std::size_t>(node)].norm(); };
    const double energy = code.energy();
    double least = outer, when = 0, unround = 0;
    while (code.time() < 7e-9 && code.advance(7e-9 - code.time())) {
      const auto [low, high] = std::ranges::minmax(code.mesh().rim, {}, radius);
      unround = std::max(unround, radius(high) / radius(low) - 1);
      if (radius(low) < least) least = radius(low), when = code.time();
    }
    // the nodes stand outside of the circle of their polygon's area
    const double turn = std::numbers::pi / 2 / 36;
    least *= std::sqrt(std::sin(turn) / turn);
    const exact::ShellStop stop =
        exact::compressible_shell_stop(scenes::exact_solid(material), inner, outer, speed, 120);
    EXPECT_NEAR(least / stop.radius, 1, 5e-4) << speed;
    EXPECT_NEAR(when / stop.time, 1, 5e-3) << speed;
    EXPECT_LT(unround, 1e-11);
    EXPECT_NEAR(code.energy() / energy, 1, 1e-13);
  }
}

TEST(Lagrangian2d, ScalesBitForBit) {
  mpm::Scene small = scenes::cavity(0.1e-6), large = small;
  for (double* length : {&large.block_width, &large.block_height, &large.cavity_radius,
                         &large.cavity_center_height, &large.end_time})
    *length *= 1024;
  const Collapse a = collapse(small, 6), b = collapse(large, 6);
  ASSERT_EQ(a.area.size(), b.area.size());
  for (std::size_t k = 0; k < a.area.size(); ++k) EXPECT_EQ(a.area[k] * 1024 * 1024, b.area[k]);
}

// The reference of the weak collapse: three coarse meshes lead to the limit of finer ones, 0.7663.
TEST(Lagrangian2d, WeakCollapseConverges) {
  mpm::Scene scene = scenes::cavity(0.1e-6);
  scene.end_time = 16e-9;
  const CollapseLadder l = collapse_ladder(scene, 5);
  EXPECT_NEAR(l.meshes[0].area[0] / (std::numbers::pi * 2.25e-12), 1, 1e-12);
  for (const Collapse& c : l.meshes) {
    EXPECT_EQ(c.stopped, "");
    EXPECT_LT(c.energy_error, 1e-12);
  }
  EXPECT_NEAR(l.collapsibility.extrapolated, 0.7663, 0.004);
  EXPECT_GT(l.collapsibility.order, 1.3);

  // without the limiter, viscosity damps the collapse on all of them
  const Collapse damped = collapse(scene, 5, 2, {.limiter = false});
  EXPECT_LT(damped.collapsibility, l.meshes[1].collapsibility - 0.05);
}

TEST(Lagrangian2d, SaysWhereTheMeshStops) {
  mpm::Scene scene = scenes::cavity(0.1e-6);
  scene.impact_speed = 1120;
  scene.end_time = 4e-9;
  const Collapse c = collapse(scene, 6);
  EXPECT_NE(c.stopped, "");
  EXPECT_LT(c.stop_time, 3e-9);
  EXPECT_TRUE(std::isnan(c.collapsibility));
  EXPECT_TRUE(std::isnan(c.area_at(3.5e-9)));

  scene.cavity_center_height = scene.cavity_radius;
  EXPECT_THROW(collapse(scene, 6), std::invalid_argument);
  scene.space = mpm::Space::axisymmetric;
  EXPECT_THROW(collapse(scene, 6), std::invalid_argument);
}

}  // namespace
