// Scenes of three axes: their measures, and what they share with the spaces of two.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "libmpm/core/errors.hpp"
#include "libmpm/measure/surface.hpp"
#include "libmpm/measure/void_area.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/simulation.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "tests/libmpm/scenes.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

using mpm::Vec3;
using std::numbers::pi;

/// With what a study of three axes uses where it says nothing.
mpm::Scene three_d(const mpm::Scene& s) { return scenes::in_space(mpm::Space::three_d, s); }

/// A spherical cavity in a small block.
mpm::Scene sphere(double cell) {
  mpm::Scene s = three_d(scenes::cavity(cell));
  s.block_width = 4e-6;
  s.block_height = 4e-6;
  return s;
}

TEST(SphereMesh, PartsAreThoseOfTheWhole) {
  for (const auto& [part, whole] :
       {std::pair(mpm::SpherePart::whole, 1), std::pair(mpm::SpherePart::quarter, 4),
        std::pair(mpm::SpherePart::octant, 8)}) {
    const mpm::SphereMesh mesh = mpm::sphere_mesh(part, 24);
    EXPECT_EQ(mesh.triangles.size(), 8u * 24 * 24 / static_cast<unsigned>(whole));
    double volume = 0, area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      mpm::Mat3 edges;
      edges << mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)],
          mesh.points[static_cast<std::size_t>(c)];
      const double six = edges.determinant();
      EXPECT_GT(six, 0) << "seen from outside they turn to the left";
      volume += six / 6;
    }
    for (const double share : mesh.shares()) area += share;
    EXPECT_NEAR(whole * volume / (4 * pi / 3), 1, 0.003);
    EXPECT_NEAR(whole * area / (4 * pi), 1, 0.0015);
    for (const Vec3& x : mesh.points) EXPECT_NEAR(x.norm(), 1, 1e-15);
  }
}

TEST(Surface, IsTheSphereAtFirst) {
  const Vec3 center(0, 1.9e-6, 0);
  for (const bool quarter : {true, false}) {
    const mpm::Surface surface(center, 1.5e-6, 0.1e-6, quarter);
    EXPECT_NEAR(surface.volume() / (4 * pi / 3 * std::pow(1.5e-6, 3)), 1, 1e-12);
    const mpm::Contour section = surface.section();
    EXPECT_NEAR(section.area() / (pi * 1.5e-6 * 1.5e-6), 1, 0.1 / (15 * 15));
    EXPECT_NEAR(section.width() / section.height(), 1, 1e-12);
    EXPECT_NEAR(section.lower_upper_ratio(), 1, 1e-12);
    EXPECT_NEAR(section.centroid().y() / center.y(), 1, 1e-12);
    EXPECT_FALSE(surface.crosses_itself());
    EXPECT_LT(surface.upstream_pole().y(), 0.41e-6);
    EXPECT_GT(surface.downstream_pole().y(), 3.39e-6);
  }
}

/// All nodes of a grid of 20 cells a side at v(x).
template <class Velocity>
mpm::BasicGrid<3> moved(const Velocity& velocity) {
  mpm::BasicGrid<3> grid(Vec3::Zero(), Vec3::Ones(), 20, 20);
  grid.grow_to_row(24);
  for (auto& n : grid.nodes()) n.mass = 1, n.velocity = velocity(grid.position(n));
  return grid;
}

TEST(Surface, MovesWithTheGridAndStaysOnItsMirrors) {
  mpm::Surface surface(Vec3(0, 10, 0), 5, 1, true);
  const double before = surface.volume();
  // an affine motion that the mirrors allow, without change of volume
  const auto grid =
      moved([](const Vec3& x) { return Vec3(-0.2 * x.x(), 0.5 * (x.y() - 10) + 1, -0.3 * x.z()); });
  surface.advance(grid, 0.01);
  const double growth = (1 - 0.002) * (1 + 0.005) * (1 - 0.003);
  EXPECT_NEAR(surface.volume() / before, growth, 1e-13);
  EXPECT_NEAR(surface.section().width() / surface.section().height(), (1 - 0.002) / (1 + 0.005), 1e-13);
  EXPECT_EQ(surface.upstream_pole().x(), 0);
  EXPECT_EQ(surface.upstream_pole().z(), 0);
  EXPECT_FALSE(surface.crosses_itself());
}

// A jet along the axis goes through the far side; it does on both meridians, whichever is looked at.
TEST(Surface, KnowsThatItCrossesItself) {
  for (const int thin : {0, 2}) {
    mpm::Surface surface(Vec3(0, 10, 0), 5, 1, true);
    const auto grid = moved([&](const Vec3& x) {
      const bool in_jet = std::abs(x[thin]) < 2.5 && x.y() < 10;
      return Vec3(0, in_jet ? 12 : 0, 0);
    });
    EXPECT_FALSE(surface.crosses_itself());
    surface.advance(grid, 1);
    EXPECT_TRUE(surface.crosses_itself());
  }
}

// 30 cells across, wherever the centre lies in its cell.
TEST(CavityVolume, AtRestIsThatOfTheSphere) {
  struct Case {
    double radius, height;
    int particles;
    mpm::Symmetry symmetry;
  };
  for (const auto& [radius, height, particles, symmetry] :
       {Case{1.5e-6, 1.9e-6, 8, mpm::Symmetry::half}, Case{1.47e-6, 1.93e-6, 8, mpm::Symmetry::half},
        Case{1.53e-6, 1.95e-6, 1, mpm::Symmetry::half}, Case{1.5e-6, 1.93e-6, 1, mpm::Symmetry::full},
        Case{1.5e-6, 1.9e-6, 27, mpm::Symmetry::half}}) {
    mpm::Scene s = sphere(0.1e-6);
    s.cavity_radius = radius, s.cavity_center_height = height;
    s.numerics.particles_per_cell = particles, s.numerics.symmetry = symmetry;
    const auto state = mpm::build_state<3>(s);
    mpm::BasicVoidArea<3> hole(Vec3(0, height, 0), radius, symmetry == mpm::Symmetry::full, particles);
    SCOPED_TRACE(testing::Message() << radius << ' ' << height << ' ' << particles);
    EXPECT_NEAR(hole.update(state) / (pi * radius * radius), 1, 2e-3);
    EXPECT_NEAR(hole.volume() / (4 * pi / 3 * std::pow(radius, 3)), 1, 2e-3);
    EXPECT_FALSE(hole.joined_outside() || hole.touches_wall());
    EXPECT_EQ(hole.closed_regions(), 1);
  }
}

TEST(CavityVolume, KnowsTheOutside) {
  mpm::Scene s = sphere(0.2e-6);
  const auto look = [&](double height, auto look_at) {
    s.cavity_center_height = height;
    mpm::BasicVoidArea<3> hole(Vec3(0, height, 0), s.cavity_radius, false, 8);
    hole.update(mpm::build_state<3>(s));
    look_at(hole);
  };
  look(2.5e-6, [](const auto& hole) { EXPECT_TRUE(hole.joined_outside()); });
  look(1.5e-6, [](const auto& hole) {
    EXPECT_TRUE(hole.touches_wall());
    EXPECT_FALSE(hole.joined_outside());
  });
}

TEST(ThreeDScene, ItsEstimateAndItsMassAreThoseOfTheSolid) {
  const mpm::Scene s = sphere(0.2e-6);
  const auto state = mpm::build_state<3>(s);
  double mass = 0;
  for (const double m : state.particles.mass) mass += m;
  const double quarter = 4e-6 * 4e-6 * 4e-6 / 4 - pi / 3 * std::pow(s.cavity_radius, 3);
  EXPECT_NEAR(mass / (s.material.reference_density * quarter), 1, 2e-3);
  EXPECT_NEAR(static_cast<double>(mpm::estimate(s).particles) / static_cast<double>(state.particles.size()),
              1, 0.05);
}

// The motion along y does not know of the other axes.
TEST(ThreeDScene, APlanarShockIsThatOfPlaneStrain) {
  for (const auto scheme : {mpm::ShapeFunction::gimp, mpm::ShapeFunction::bspline2}) {
    const int particles = scheme == mpm::ShapeFunction::gimp ? 1 : 4;
    expect_all_hold(
        mpm::verification::planar_spaces_numbers({.scheme = scheme, .particles_per_cell = particles}));
  }
  const mpm::RunResult r = mpm::run(three_d(scenes::planar(200, 2e-6, 0.1e-6, 0.5e-9)));
  EXPECT_LT(r.energy_error, 1e-12);
  EXPECT_LT(scenes::metric(r, "momentum_error"), 1e-12);
}

// All of the block against a quarter of it, and all of the shell against an octant.
TEST(ThreeDScene, PartsAreThoseOfTheWhole) {
  mpm::Scene cavity = sphere(0.5e-6), shell = three_d(scenes::shell(277, 0.375e-6));
  cavity.end_time = 0.8e-9;
  for (mpm::Scene s : {cavity, shell}) {
    const mpm::RunResult part = mpm::run(s);
    s.numerics.symmetry = mpm::Symmetry::full;
    const mpm::RunResult whole = mpm::run(s);
    ASSERT_EQ(part.status, mpm::RunStatus::done) << part.reason;
    ASSERT_EQ(whole.status, mpm::RunStatus::done) << whole.reason;
    EXPECT_EQ(whole.steps, part.steps);
    EXPECT_GT(whole.particles, part.particles * 3);
    EXPECT_EQ(whole.outcome, part.outcome);
    if (part.collapsibility) {
      EXPECT_GT(*part.collapsibility, 0.1);
      EXPECT_NEAR(*whole.collapsibility, *part.collapsibility, 1e-9);
      EXPECT_NEAR(*whole.final_area / *part.final_area, 1, 1e-9);
      EXPECT_NEAR(1 - scenes::metric(part, "final_volume_m3") / scenes::metric(part, "initial_volume_m3"),
                  *part.collapsibility, 1e-12);
      EXPECT_NEAR(whole.area_history.back().void_area / part.area_history.back().void_area, 1, 1e-9);
    } else {
      EXPECT_NEAR(scenes::metric(whole, "stop_radius_m") / scenes::metric(part, "stop_radius_m"), 1, 1e-9);
    }
    EXPECT_LT(whole.energy_error, 1e-12);
  }
}

TEST(ThreeDScene, SnapshotsHaveAllThatIsThere) {
  struct Keep : mpm::Observer {
    mpm::Snapshot last;
    void on_snapshot(const mpm::Snapshot& s) override { last = s; }
  } keep;
  mpm::Scene s = sphere(0.5e-6);
  s.end_time = 0.3e-9;
  s.measures.snapshots = {0.25e-9};
  ASSERT_EQ(mpm::run(s, keep).status, mpm::RunStatus::done);
  const mpm::Snapshot& l = keep.last;
  ASSERT_GT(l.x.size(), 100u);
  EXPECT_TRUE(l.has_depth());
  double volume = 0;
  for (std::size_t p = 0; p < l.x.size(); ++p) volume += l.mass[p] / l.density[p];
  EXPECT_NEAR(volume / (16e-12 * 4e-6 / 4 - pi / 3 * std::pow(s.cavity_radius, 3)), 1, 0.02);
  for (const auto* column : {&l.z, &l.velocity_z, &l.stress_xz, &l.stress_yz}) {
    ASSERT_EQ(column->size(), l.x.size());
    EXPECT_TRUE(std::ranges::any_of(*column, [](double v) { return v != 0; }));
  }
}

TEST(ThreeDScene, SaysWhatItDoesNotHave) {
  const mpm::Scene good = sphere(0.25e-6);
  EXPECT_TRUE(mpm::find_problems(good).empty());
  const auto problem = [&](auto change) {
    mpm::Scene s = good;
    change(s);
    const auto all = mpm::find_problems(s);
    return all.size() == 1 ? all[0].parameter + ": " + all[0].allowed
                           : std::to_string(all.size()) + " problems";
  };
  EXPECT_EQ(problem([](mpm::Scene& s) { s.numerics.particles_per_cell = 4; }),
            "particles_per_cell: 1, 8 or 27 when space is \"three-d\"");
  for (const auto scheme : {mpm::ShapeFunction::bspline3, mpm::ShapeFunction::linear})
    EXPECT_THAT(problem([&](mpm::Scene& s) { s.numerics.scheme = scheme; }), testing::StartsWith("kernel: "));
  EXPECT_THAT(problem([](mpm::Scene& s) { s.numerics.scheme = mpm::ShapeFunction::cpdi; }),
              testing::StartsWith("scheme: "));
  EXPECT_THAT(problem([](mpm::Scene& s) { s.numerics.cell_size = 1e-9; }),
              testing::HasSubstr("1e9 particles"));
  EXPECT_THROW(mpm::Simulation{good}, mpm::InputError);
  EXPECT_THROW(mpm::Simulation3{scenes::cavity(0.25e-6)}, mpm::InputError);
}

// A body of one's own, and a run of it step by step.
TEST(ThreeDScene, TakesABodyOfOnesOwn) {
  mpm::Scene s = sphere(0.5e-6);
  auto body = mpm::build_state<3>(s);
  auto lost = body;
  lost.particles.position[3].z() = -1e-3;
  EXPECT_THAT([&] { mpm::Simulation3(s, lost); },
              testing::ThrowsMessage<mpm::InputError>(testing::HasSubstr("z = -0.001 m")));
  mpm::Simulation3 simulation(s, body);
  const double dt = 0.5 * simulation.time_step();
  for (int k = 0; k < 3; ++k) simulation.step(dt);
  EXPECT_EQ(simulation.state().step, 3);
  EXPECT_NEAR(simulation.time(), 3 * dt, 1e-20);
  EXPECT_GT(simulation.result().metrics.size(), 3u);
}

}  // namespace
