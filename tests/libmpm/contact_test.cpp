// Contact between bodies: what a step keeps, when it begins and ends, friction, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "libmpm/contact/surface_table.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/measure/gauges.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/cpdi.hpp"
#include "libmpm/verification/problems/contact_scenes.hpp"
#include "tests/libmpm/resumed.hpp"

namespace {

using namespace mpm::verification::contact_scenes;
using testing::HasSubstr;

mpm::RunResult balanced_run(const mpm::Scene& s) {
  const auto problems = mpm::find_problems(s);
  for (const mpm::Problem& p : problems)
    ADD_FAILURE() << p.parameter << " = " << p.value << ": " << p.allowed;
  if (!problems.empty()) return {};
  mpm::RunResult r = mpm::run(s);
  EXPECT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_LT(r.energy_error, 1e-12);
  EXPECT_LT(metric(r, "momentum_error"), 1e-12);
  return r;
}

template <class Shape>
class SurfaceTableTest : public testing::Test {};
using Shapes = testing::Types<mpm::Gimp, mpm::Cpdi, mpm::BSpline2, mpm::BSpline3>;
TYPED_TEST_SUITE(SurfaceTableTest, Shapes);

// A block whose edge is anywhere between two nodes: the nodes around it agree on where that is.
TYPED_TEST(SurfaceTableTest, EveryNodeNearAnEdgeKnowsWhereItIs) {
  for (const int per_edge : {1, 2, 3}) {
    const double half = 0.5 / per_edge;
    const auto table = mpm::SurfaceTable::of<TypeParam>(half);
    mpm::Grid grid({0, 0}, {1, 1}, 20);
    for (double edge = 9.03; edge < 10; edge += 0.09)
      for (int node = 9; node <= 10; ++node) {
        double sum = 0, moment = 0;
        for (double x = edge - half; x > 4; x -= 2 * half) {
          double w = 0;
          if constexpr (mpm::ProductShape<TypeParam>) {
            const auto weights = TypeParam::evaluate(x, half);
            const int k = node - weights.first;
            w = k >= 0 && k < weights.nodes ? weights.value[static_cast<std::size_t>(k)] : 0;
          } else {
            const auto weights = mpm::Gimp::evaluate(x, half);
            const int k = node - weights.first;
            w = k >= 0 && k < weights.nodes ? weights.value[static_cast<std::size_t>(k)] : 0;
          }
          sum += w, moment += w * (x - node);
        }
        if (sum * 2 * half < 0.01) continue;
        EXPECT_NEAR(table.surface(moment / sum), edge - node, 0.01) << per_edge << " " << edge << " " << node;
      }
  }
}

/// `rebound`: speed at least, of 10 m/s.
void expect_bounce(const mpm::Scene& s, double rebound) {
  const mpm::RunResult r = balanced_run(s);
  ASSERT_EQ(r.status, mpm::RunStatus::done);
  // they part, as fast as what artificial viscosity and the grid leave of their approach
  EXPECT_LT(metric(r, "v_low.end"), -rebound);
  EXPECT_NEAR(metric(r, "v_high.end") / metric(r, "v_low.end"), -1, 1e-9);
  const mpm::History &force = *r.history("force"), &top = *r.history("top"), &bottom = *r.history("bottom");
  EXPECT_EQ(force.values.back(), 0);
  // the first push, within a sample (0.04 cells) of touching
  std::size_t k = 0;
  while (force.values[k] == 0) ++k;
  const double h = s.numerics.cell_size;
  EXPECT_LT(bottom.values[k] - top.values[k], 0.1 * h);
  EXPECT_GT(bottom.values[k] - top.values[k], -0.1 * h);
  for (const double f : force.values) EXPECT_LE(f, 0);
  // what was given is what the body has
  const double mass = metric(r, "p_high.end") / metric(r, "v_high.end");
  EXPECT_NEAR(metric(r, "given.end") / (mass * (metric(r, "v_high.end") + 10)), 1, 1e-9);
  EXPECT_GT(metric(r, "contact_heat_fraction"), 0);
}

TEST(Contact, TwoBlocksBounceInEverySpace) {
  for (const mpm::Space space : {mpm::Space::plane_strain, mpm::Space::axisymmetric, mpm::Space::three_d}) {
    SCOPED_TRACE(static_cast<int>(space));
    mpm::Scene s = two_blocks(space);
    add_gauge(s, "p_high", "momentum_y", "high");
    expect_bounce(s, 6);
  }
}

TEST(Contact, TwoBlocksBounceWithEverySchemeAndTransfer) {
  for (const auto scheme : {mpm::ShapeFunction::gimp, mpm::ShapeFunction::bspline2, mpm::ShapeFunction::cpdi,
                            mpm::ShapeFunction::bspline3})
    for (const int transfer : {0, 1, 2}) {
      SCOPED_TRACE(static_cast<int>(scheme) * 10 + transfer);
      mpm::Scene s = two_blocks(mpm::Space::plane_strain);
      add_gauge(s, "p_high", "momentum_y", "high");
      s.numerics.scheme = scheme;
      if (transfer == 1) s.numerics.transfer = mpm::Transfer::apic;
      if (transfer == 2) s.numerics.pic_fraction = 0.01;
      expect_bounce(s, scheme == mpm::ShapeFunction::cpdi ? 4.5 : 6);
    }
}

// Without a rule of contact they share the grid, as they have always done, and feel each other from afar.
TEST(Contact, WithoutItBodiesAreWelded) {
  mpm::Scene s = two_blocks(mpm::Space::plane_strain);
  s.end_time = 0.12e-3;  // 0.6 cells apart
  EXPECT_NEAR(metric(balanced_run(s), "v_low.end"), 10, 1e-9);
  s.composition.contacts.clear();
  s.measures.gauges.resize(4);
  const mpm::RunResult welded = balanced_run(s);
  EXPECT_LT(metric(welded, "v_low.end"), 9.5);
  s.composition.contacts = {{{}, {}, mpm::ContactLaw::welded}};
  EXPECT_EQ(metric(welded, "v_low.end"), metric(balanced_run(s), "v_low.end"));
}

// Discs that meet beside their centres, over a mirror: momentum, energy, and the mirror image.
TEST(Contact, HalfOfASymmetricSceneIsHalfOfIt) {
  constexpr double h = 1e-3;
  const auto scene = [&](bool half) {
    mpm::Scene s = box(mpm::Space::plane_strain, h, {half ? 0 : -8 * h, 0, 0}, {8 * h, 30 * h, 0});
    if (half) face(s, mpm::Side::left) = mpm::Face::mirror;
    s.composition.bodies = {{.name = "low", .shape = ball({0, 8 * h, 0}, 4 * h), .velocity = {0, 5, 0}},
                            {.name = "high", .shape = ball({0, 17 * h, 0}, 4 * h), .velocity = {0, -5, 0}}};
    s.composition.contacts = {coulomb(0.3)};
    s.end_time = 0.3e-3;
    s.measures.area_every = 10e-6;
    add_gauge(s, "v_low", "velocity_y", "low");
    add_contact_gauge(s, "force", "force_y", "low", "high");
    return s;
  };
  const mpm::RunResult half = balanced_run(scene(true)), full = balanced_run(scene(false));
  EXPECT_NEAR(metric(half, "v_low.end") / metric(full, "v_low.end"), 1, 1e-9);
  EXPECT_NEAR(metric(half, "force.min") / metric(full, "force.min"), 0.5, 1e-9);
  EXPECT_LT(metric(full, "v_low.end"), -3);
}

/// A block on a plane that is inclined by 30 degrees: gravity is turned, or the plane is.
mpm::Scene sliding(double friction, bool turned, bool rigid) {
  constexpr double h = 0.1, g = 9.81, angle = std::numbers::pi / 6;
  const double c = std::cos(angle), s_ = std::sin(angle);
  mpm::Scene s = turned ? box(mpm::Space::plane_strain, h, {-1, -4, 0}, {5, 3, 0})
                        : box(mpm::Space::plane_strain, h, {-1, -1, 0}, {5, 2, 0});
  s.material = elastic(1e7);
  s.composition.bodies = {{.name = "block", .shape = block({0, 0, 0}, {2, 1, 0})}};
  if (rigid) {
    s.composition.bodies.push_back(rigid_plane(turned ? angle : 0));
  } else {
    s.composition.bodies.push_back({.name = "plane", .shape = block({-1, -1, 0}, {5, 0, 0})});
    for (const mpm::Side side : {mpm::Side::left, mpm::Side::right, mpm::Side::bottom})
      face(s, side) = mpm::Face::mirror;
  }
  if (turned) s.composition.bodies[0].shape.rotation = {c, s_, 0, -s_, c, 0, 0, 0, 1};
  s.composition.gravity = turned ? mpm::Triple{0, -g, 0} : mpm::Triple{g * s_, -g * c, 0};
  s.composition.gravity_rise = 0.15;
  s.composition.contacts = {friction > 0 ? coulomb(friction) : frictionless()};
  s.end_time = 0.6;
  s.measures.area_every = 0.005;
  for (const char* of : {"velocity_x", "velocity_y"}) add_gauge(s, of, of, "block");
  add_contact_gauge(s, "force_y", "force_y", "block", "plane");
  return s;
}

/// Down the slope, from 0.2 s on [m/s^2].
double acceleration(const mpm::RunResult& r, bool turned) {
  const double angle = turned ? std::numbers::pi / 6 : 0;
  const auto speed = [&](double time) {
    const auto at = [&](const char* name) { return *mpm::reduced(*r.history(name), {"", {}, time, time}); };
    return at("velocity_x") * std::cos(angle) - at("velocity_y") * std::sin(angle);
  };
  return (speed(0.6) - speed(0.2)) / 0.4;
}

TEST(Contact, ABlockSlidesAsCoulombSays) {
  const double along = 9.81 * 0.5, across = 9.81 * std::sqrt(0.75);
  for (const bool turned : {false, true}) {
    SCOPED_TRACE(turned);
    EXPECT_NEAR(acceleration(balanced_run(sliding(0, turned, true)), turned) / along, 1, 0.001);
    const mpm::RunResult r = balanced_run(sliding(0.3, turned, true));
    EXPECT_NEAR(acceleration(r, turned) / (along - 0.3 * across), 1, 0.02);
    EXPECT_GT(metric(r, "friction_heat_fraction"), 0.4);
    EXPECT_NEAR(acceleration(balanced_run(sliding(1, turned, true)), turned) / along, 0, 0.02);
  }
  // on a plane that gives way
  EXPECT_NEAR(acceleration(balanced_run(sliding(0, false, false)), false) / along, 1, 0.01);
  EXPECT_NEAR(acceleration(balanced_run(sliding(0.3, false, false)), false) / (along - 0.3 * across), 1,
              0.03);
}

TEST(Contact, AStackAtRestStaysAndDoesNotHeat) {
  constexpr double h = 0.1, g = 9.81;
  mpm::Scene s = box(mpm::Space::plane_strain, h, {-1, 0, 0}, {3, 4, 0});
  s.material = elastic(1e7);
  face(s, mpm::Side::bottom) = mpm::Face::wall;
  s.composition.bodies = {{.name = "low", .shape = block({0, 0, 0}, {2, 1, 0})},
                          {.name = "middle", .shape = block({0.2, 1, 0}, {1.8, 2, 0})},
                          {.name = "high", .shape = block({0.4, 2, 0}, {1.6, 3, 0})}};
  s.composition.gravity = {0, -g, 0};
  s.composition.gravity_rise = 0.5;
  s.composition.contacts = {coulomb(0.3)};
  s.end_time = 1.5;
  s.measures.area_every = 0.01;
  add_gauge(s, "x", "center_x", "high"), add_gauge(s, "y", "center_y", "high");
  add_gauge(s, "internal", "internal_energy", "all");
  add_contact_gauge(s, "load", "force_y", "high", "middle");
  s.measures.gauges.back().reductions = {{"mean", mpm::Window::mean, 1, 1.5}};
  const mpm::RunResult r = balanced_run(s);
  EXPECT_NEAR(metric(r, "x.end"), r.history("x")->values.front(), 0.002 * h);
  // all three give way by their weight, of 1.2, 1.6 and 2 m^2 on as wide a foot
  EXPECT_NEAR(metric(r, "y.end"), 2.5, 0.1 * h);
  EXPECT_NEAR(metric(r, "load.mean") / (1000 * 1.2 * g), 1, 0.01);
  // no more than the strain that carries them: 1e4 N/m^2 each over 1e7 Pa
  EXPECT_LT(metric(r, "internal.end"), 200);
  EXPECT_LT(metric(r, "final_kinetic_fraction"), 0.01);
}

TEST(Contact, ARigidPistonDoesWork) {
  constexpr double h = 1e-3;
  mpm::Scene s = box(mpm::Space::plane_strain, h, {0, 0, 0}, {8 * h, 30 * h, 0});
  face(s, mpm::Side::left) = face(s, mpm::Side::right) = mpm::Face::mirror;
  s.composition.bodies = {{.name = "piston",
                           .shape = block({-h, -5 * h, 0}, {9 * h, 4 * h, 0}),
                           .velocity = {0, 10, 0},
                           .rigid = true},
                          {.name = "block", .shape = block({0, 5 * h, 0}, {8 * h, 20 * h, 0})}};
  s.composition.contacts = {frictionless()};
  s.end_time = 0.111e-3;  // before the wave is back
  s.measures.area_every = 1e-6;
  add_contact_gauge(s, "force", "force_y", "block", "piston");
  s.measures.gauges.back().reductions = {{"mean", mpm::Window::mean, 105e-6, 111e-6}};
  const mpm::RunResult r = balanced_run(s);
  const double c = mpm::sound_speed_at_rest(s.material);
  EXPECT_NEAR(metric(r, "force.mean") / (1000 * c * 10 * 8 * h), 1, 0.05);
  EXPECT_NEAR(metric(r, "rigid_work_fraction"), 1, 1e-9);
}

TEST(Contact, GoesOnFromACheckpointWithTheSameBits) {
  const mpm::Scene s = two_blocks(mpm::Space::plane_strain);
  expect_same_from_a_checkpoint(s, 120);
}

// A heap of many bodies: each pair that touches is held, and nothing is lost.
TEST(Contact, HasAnyNumberOfBodies) {
  constexpr double h = 1e-3;
  mpm::Scene s = box(mpm::Space::plane_strain, h, {0, 0, 0}, {48 * h, 60 * h, 0});
  face(s, mpm::Side::left) = face(s, mpm::Side::right) = mpm::Face::mirror;
  face(s, mpm::Side::bottom) = mpm::Face::wall;
  for (int k = 0; k < 100; ++k) {
    const double x = (2.4 + 4.6 * (k % 10) + 0.3 * (k / 10 % 2)) * h, y = (2.6 + 4.6 * (k / 10)) * h;
    s.composition.bodies.push_back(
        {.name = std::to_string(k), .shape = ball({x, y, 0}, 2.1 * h), .velocity = {0, -20, 0}});
  }
  s.composition.contacts = {coulomb(0.3)};
  s.end_time = 0.15e-3;
  s.measures.area_every = 10e-6;
  balanced_run(s);
}

std::string problems(const mpm::Scene& s) {
  std::string text;
  for (const mpm::Problem& p : mpm::find_problems(s))
    text += p.parameter + " = " + p.value + ": must be " + p.allowed + "\n";
  return text;
}

TEST(Contact, WhatCannotBeIsRefused) {
  const mpm::Scene good = two_blocks(mpm::Space::plane_strain);
  EXPECT_EQ(problems(good), "");
  mpm::Scene s = good;
  s.composition.contacts = {{"low", "hihg", mpm::ContactLaw::frictionless}};
  EXPECT_THAT(problems(s), HasSubstr("contact 1, between = hihg: must be names of bodies"));
  s.composition.contacts = {{"low", "low", mpm::ContactLaw::frictionless}};
  EXPECT_THAT(problems(s), HasSubstr("low and itself"));
  s = good;
  s.composition.contacts.push_back(coulomb(0.1));
  EXPECT_THAT(problems(s), HasSubstr("contact 2, between = all others"));
  s = good;
  s.numerics.kernel = mpm::Kernel::fast;
  EXPECT_THAT(problems(s), HasSubstr("kernel = fast"));
  s = good;
  s.composition.bodies.push_back({.name = "third", .shape = block({0, 19e-3, 0}, {4e-3, 21e-3, 0})});
  s.composition.contacts = {{"low", "high", mpm::ContactLaw::frictionless}};
  s.measures.gauges.clear();
  EXPECT_THAT(problems(s), HasSubstr("are welded to the same body"));
  s = good;
  s.composition.bodies[0].rigid = true;
  s.measures.gauges.clear();
  EXPECT_EQ(problems(s), "");
  s.composition.contacts.clear();
  EXPECT_THAT(problems(s), HasSubstr("nothing is welded to a rigid body"));
  s = good;
  s.composition.bodies[0].rigid = s.composition.bodies[1].rigid = true;
  EXPECT_THAT(problems(s), HasSubstr("rigid bodies alone"));
  s = good;
  s.composition.contacts = {{{}, {}, mpm::ContactLaw::welded}};
  EXPECT_THAT(problems(s), HasSubstr("gauge.force.contact = low, high"));
}

}  // namespace
