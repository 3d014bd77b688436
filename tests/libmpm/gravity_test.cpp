// Gravity: free fall, its work in the balance of energy, and what a floor that carries a body pushes.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/scene/build.hpp"
#include "libmpm/simulation.hpp"
#include "tests/libmpm/resumed.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

constexpr double g = 2e9;  // m/s^2: a body of micrometres falls by a cell in some nanoseconds

/// A square in an empty box, at rest.
mpm::Scene falling(mpm::Space space, const mpm::Triple& gravity) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::bodies;
  s.material = mpm::named_material("aluminium");
  s.space = space;
  s.numerics = mpm::default_numerics(s.kind, space);
  s.numerics.kernel = mpm::Kernel::reference;
  s.numerics.cell_size = 0.5e-6;
  s.composition.high = {8e-6, 8e-6, 8e-6};
  const bool axial = space == mpm::Space::axisymmetric;
  if (axial) s.composition.faces[static_cast<std::size_t>(mpm::Side::left)] = mpm::Face::mirror;
  const double x = axial ? 0 : 3e-6;
  s.composition.bodies = {
      {.name = "block", .shape = {mpm::Shape::Form::block, {x, 3e-6, 3e-6, x + 2e-6, 5e-6, 5e-6}, {}}}};
  s.composition.gravity = gravity;
  s.end_time = 20e-9;
  s.measures.area_every = 1e-9;
  const auto gauge = [&](const char* name, const char* of) {
    s.measures.gauges.push_back({.name = name, .of = of, .target = mpm::GaugeTarget::body});
  };
  gauge("y", "center_y"), gauge("vy", "velocity_y"), gauge("vx", "velocity_x");
  return s;
}

double metric(const mpm::RunResult& r, const char* name) {
  const mpm::Metric* found = r.find(name);
  return found ? found->value : std::nan("");
}

void expect_balanced(const mpm::RunResult& r) {
  EXPECT_LT(r.energy_error, 1e-12);
  EXPECT_LT(metric(r, "momentum_error"), 1e-12);
}

TEST(Gravity, ABodyInFreeFallFallsAsGalileoSays) {
  for (const mpm::Space space : {mpm::Space::plane_strain, mpm::Space::axisymmetric, mpm::Space::three_d}) {
    const double across = space == mpm::Space::axisymmetric ? 0 : 0.25 * g;
    mpm::Scene s = falling(space, {across, -g, 0});
    if (space == mpm::Space::three_d) s.end_time = 5e-9;
    const mpm::RunResult r = mpm::run(s);
    ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
    const double t = s.end_time, fall = 0.5 * g * t * t;
    EXPECT_NEAR(metric(r, "vy.end"), -g * t, 1e-10 * g * t);
    EXPECT_NEAR(metric(r, "vx.end"), across * t, 1e-10 * g * t);
    // velocities are half a step older than places
    const double dt = t / static_cast<double>(r.steps);
    EXPECT_NEAR(metric(r, "y.end") - r.history("y")->values.front(), -fall, 1.01 * 0.5 * g * t * dt);
    expect_balanced(r);
    EXPECT_NEAR(metric(r, "gravity_work_fraction"), 1, 1e-10);  // all the energy there is
    EXPECT_NEAR(metric(r, "final_kinetic_fraction"), 1, 1e-8);
  }
}

TEST(Gravity, AFloorCarriesTheWeight) {
  for (const mpm::Face floor : {mpm::Face::mirror, mpm::Face::wall}) {
    mpm::Scene s = falling(mpm::Space::plane_strain, {0, -g / 100, 0});
    s.composition.bodies[0].shape.numbers = {0, 0, 0, 8e-6, 4e-6, 0};
    auto& faces = s.composition.faces;
    faces[0] = faces[1] = mpm::Face::mirror;
    faces[static_cast<std::size_t>(mpm::Side::bottom)] = floor;
    s.measures.gauges.push_back({.name = "push",
                                 .of = "force",
                                 .target = mpm::GaugeTarget::wall,
                                 .reductions = {{"mean", mpm::Window::mean, 2e-9, 40e-9}}});
    s.end_time = 40e-9;
    s.measures.area_every = 0.1e-9;
    const mpm::RunResult r = mpm::run(s);
    ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
    expect_balanced(r);
    const double weight = s.material.reference_density * 8e-6 * 4e-6 * g / 100;
    EXPECT_NEAR(metric(r, "push.mean") / weight, 1, 0.05);
  }
}

TEST(Gravity, WhatCannotBeIsRefused) {
  mpm::Scene s = falling(mpm::Space::axisymmetric, {1, -g, 0});
  EXPECT_EQ(mpm::find_problems(s).at(0).parameter, "box.gravity");
  s = falling(mpm::Space::plane_strain, {0, -g, 0});
  s.numerics.kernel = mpm::Kernel::fast;
  EXPECT_EQ(mpm::find_problems(s).at(0).parameter, "kernel");
  s.composition.gravity = {};
  s.numerics.kernel = mpm::Kernel::reference;
  EXPECT_EQ(mpm::find_problems(s).at(0).value, "nothing moves");
}

TEST(Gravity, GoesOnFromACheckpointWithTheSameBits) {
  const mpm::Scene s = falling(mpm::Space::plane_strain, {0, -g, 0});
  expect_same_from_a_checkpoint(s, 20);
}

}  // namespace
