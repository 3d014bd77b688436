// Scenes that are composed of bodies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "libmpm/scene/build.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/region_of.hpp"
#include "libmpm/simulation.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::Face;
using mpm::Shape;
using mpm::Side;
using mpm::Triple;
using testing::HasSubstr;

Shape block(const Triple& low, const Triple& high) {
  return {Shape::Form::block, {low[0], low[1], low[2], high[0], high[1], high[2]}, {}};
}
Shape ball(const Triple& center, double radius) {
  return {Shape::Form::ball, {center[0], center[1], center[2], radius}, {}};
}
Shape minus(Shape a, Shape b) { return {Shape::Form::difference, {}, {std::move(a), std::move(b)}}; }

Face& face(mpm::Scene& s, Side side) { return s.composition.faces[static_cast<std::size_t>(side)]; }

/// The scene of a kind with a block, as a composition without bodies: the same box, walls and numerics.
mpm::Scene boxed(mpm::Scene s) {
  s.kind = mpm::SceneKind::bodies;
  s.composition.high = {s.block_width / 2, s.block_height, s.block_width / 2};
  face(s, Side::left) = face(s, Side::right) = face(s, Side::front) = face(s, Side::back) = Face::mirror;
  face(s, Side::bottom) = Face::wall;
  return s;
}

/// A cavity impact as one body.
mpm::Scene written_out(const mpm::Scene& kind) {
  mpm::Scene s = boxed(kind);
  s.composition.bodies = {{"block",
                           minus(block(s.composition.low, s.composition.high),
                                 ball({0, kind.cavity_center_height, 0}, kind.cavity_radius)),
                           0,
                           {0, -kind.impact_speed, 0}}};
  return s;
}

template <int axes>
void expect_same_body(const mpm::Scene& a, const mpm::Scene& b, double of_velocity = 0) {
  const auto one = mpm::build_state<axes>(a), other = mpm::build_state<axes>(b);
  ASSERT_EQ(one.particles.size(), other.particles.size());
  EXPECT_EQ(one.grid.columns(), other.grid.columns());
  EXPECT_EQ(one.grid.cell(), other.grid.cell());
  const double h = a.numerics.cell_size;
  for (std::size_t p = 0; p < one.particles.size(); ++p) {
    EXPECT_LT((one.particles.position[p] - other.particles.position[p]).norm(), 1e-9 * h);
    EXPECT_NEAR(other.particles.mass[p] / one.particles.mass[p], 1, 1e-9);
    EXPECT_LE((one.particles.velocity[p] - other.particles.velocity[p]).norm(),
              of_velocity * one.particles.velocity[p].norm());
  }
}

/// What both runs measure comes out the same.
void expect_same_numbers(const mpm::Scene& a, const mpm::Scene& b) {
  const mpm::RunResult one = mpm::run(a), other = mpm::run(b);
  ASSERT_EQ(one.status, mpm::RunStatus::done) << one.reason;
  ASSERT_EQ(other.status, mpm::RunStatus::done) << other.reason;
  EXPECT_EQ(one.steps, other.steps);
  EXPECT_GT(other.metrics.size(), 8u);
  for (const mpm::Metric& metric : other.metrics) {
    const double rounding = metric.unit == "1" ? 1e-12 : 0;
    EXPECT_NEAR(metric.value, one.find(metric.name)->value, 1e-9 * std::abs(metric.value) + rounding)
        << metric.name;
  }
}

TEST(Bodies, ACavityImpactWrittenOutIsTheSame) {
  for (const mpm::Space space : {mpm::Space::plane_strain, mpm::Space::axisymmetric}) {
    mpm::Scene kind = scenes::cavity(0.2e-6);
    kind.space = space;
    kind.end_time = 1e-9;
    const mpm::Scene s = written_out(kind);
    expect_same_body<2>(kind, s);
    expect_same_numbers(kind, s);
  }
}

TEST(Bodies, OfThreeAxesToo) {
  mpm::Scene kind = scenes::cavity(0.5e-6);
  kind.space = mpm::Space::three_d;
  kind.numerics = mpm::default_numerics(kind.kind, kind.space);
  kind.numerics.cell_size = 0.5e-6;
  const mpm::Scene s = written_out(kind);
  expect_same_body<3>(kind, s);
}

TEST(Bodies, TwoBodiesWrittenOutAreTheSame) {
  mpm::Scene kind = scenes::cavity(0.2e-6);
  kind.kind = mpm::SceneKind::two_body_impact;
  kind.end_time = 1e-9;
  mpm::Scene s = boxed(kind);
  s.composition.low[1] = -1.2 * kind.block_height;  // whole cells
  face(s, Side::bottom) = Face::open;
  const Triple high = s.composition.high;
  s.composition.bodies = {
      {"flyer",
       minus(block({0, 0, 0}, high), ball({0, kind.cavity_center_height, 0}, kind.cavity_radius)),
       0,
       {0, -kind.impact_speed, 0}},
      {"struck", block({0, -kind.block_height, 0}, {high[0], 0, 0}), 0, {0, kind.impact_speed, 0}}};
  const mpm::RunResult one = mpm::run(kind), other = mpm::run(s);
  ASSERT_EQ(other.status, mpm::RunStatus::done) << other.reason;
  EXPECT_EQ(one.steps, other.steps);
  for (const char* name : {"hot_spot_temperature_K", "hot_spot_work_J_m3", "largest_density_ratio"})
    EXPECT_NEAR(other.find(name)->value / one.find(name)->value, 1, 1e-6) << name;
}

/// A ball that flies to the right.
mpm::Scene flight(mpm::Kernel kernel) {
  mpm::Scene s = boxed(scenes::cavity(0.2e-6));
  s.numerics.kernel = kernel;
  s.composition.high = {8e-6, 4e-6, 0};
  s.composition.faces = {};
  s.composition.bodies = {{"ball", ball({2e-6, 2e-6, 0}, 1e-6), 0, {500, 0, 0}}};
  s.end_time = 8e-9;
  s.measures.area_every = s.end_time / 20;
  return s;
}

/// "parameter = value: must be allowed" of all that is wrong.
std::string problems(const mpm::Scene& s) {
  std::string text;
  for (const mpm::Problem& p : mpm::find_problems(s))
    text += p.parameter + " = " + p.value + ": must be " + p.allowed + "\n";
  return text;
}

/// An imploding shell as one body: a quarter, of three axes an octant.
mpm::Scene shell_written_out(const mpm::Scene& kind) {
  mpm::Scene s = kind;
  const double h = kind.numerics.cell_size, edge = (std::ceil(kind.outer_radius / h) + 2) * h;
  s.kind = mpm::SceneKind::bodies;
  s.composition.high = {edge, edge, edge};
  s.composition.faces.fill(Face::mirror);
  face(s, Side::top) = Face::open;
  mpm::ComposedBody shell{"shell", minus(ball({}, kind.outer_radius), ball({}, kind.inner_radius))};
  const double exponent = kind.space == mpm::Space::plane_strain ? -1 : -2;
  shell.radial = {-kind.inner_speed, kind.inner_radius, exponent, {}};
  s.composition.bodies = {shell};
  return s;
}

TEST(Bodies, AnImplodingShellWrittenOutIsTheSame) {
  for (const mpm::Space space : {mpm::Space::plane_strain, mpm::Space::axisymmetric, mpm::Space::three_d}) {
    mpm::Scene kind = scenes::in_space(space, scenes::shell(225, 0.25e-6));
    kind.end_time =
        space == mpm::Space::three_d ? 0.5e-9 : 2e-9;  // before it stops, which ends the run of the kind
    const mpm::Scene s = shell_written_out(kind);
    if (space == mpm::Space::three_d) {
      expect_same_body<3>(kind, s, 1e-9);
    } else {
      expect_same_body<2>(kind, s, 1e-9);
    }
    expect_same_numbers(kind, s);
  }
}

// All parts move to the point, or away from it, as the radius says.
TEST(Bodies, MoveRadially) {
  mpm::Scene s = flight(mpm::Kernel::fast);
  mpm::ComposedBody& ball = s.composition.bodies[0];
  ball.velocity = {};
  for (const double exponent : {0.0, 1.0, 2.0}) {
    ball.radial = {-30, 0.5e-6, exponent, {2e-6, 2e-6, 0}};
    EXPECT_EQ(problems(s), "");
    const mpm::State state = mpm::build_state(s);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
      const mpm::Vec2 arm = state.particles.position[p] - mpm::Vec2(2e-6, 2e-6);
      const mpm::Vec2 expected = -30 * std::pow(arm.norm() / 0.5e-6, exponent) * arm.normalized();
      EXPECT_LT((state.particles.velocity[p] - expected).norm(), 1e-9);
    }
  }
  // the farthest part of what may be of the body
  EXPECT_NEAR(mpm::initial_speed(s), 30 * std::pow(std::sqrt(2.0) / 0.5, 2), 1e-9);
  ball.radial.exponent = -1;
  EXPECT_THAT(problems(s), HasSubstr("body ball, radial_velocity = exponent = -1: must be 0 or more"));
  ball.shape = minus(ball.shape, ball.shape);
  ball.shape.parts[1].numbers[3] = 0.5e-6;
  EXPECT_EQ(problems(s), "");
  EXPECT_NEAR(mpm::initial_speed(s), 30, 1e-9);
}

// The whole body is heated at its density of rest: P = gamma0 rho0 e.
TEST(Bodies, BeginWithAPressure) {
  mpm::Scene s = flight(mpm::Kernel::fast);
  s.composition.bodies[0].velocity = {};
  s.composition.bodies[0].energy = 1e5;
  EXPECT_EQ(problems(s), "");
  for (const mpm::Kernel kernel : {mpm::Kernel::fast, mpm::Kernel::reference}) {
    s.numerics.kernel = kernel;
    mpm::Simulation simulation(s);
    const auto& ps = simulation.state().particles;
    const double pressure = s.material.gruneisen_gamma * s.material.reference_density * 1e5;
    for (std::size_t p = 0; p < ps.size(); ++p) EXPECT_NEAR(ps.pressure[p] / pressure, 1, 1e-12);
    const mpm::RunResult r = simulation.run();
    ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
    EXPECT_LT(r.energy_error, 1e-12);
    double left = 0, mass = 0;  // the ball has grown, and rings about no pressure
    const auto& end = simulation.state().particles;
    for (std::size_t p = 0; p < end.size(); ++p) left += end.mass[p] * end.pressure[p], mass += end.mass[p];
    EXPECT_LT(std::abs(left / mass), 0.2 * pressure);
  }
  s.composition.bodies[0].energy = 1e12;
  EXPECT_THAT(problems(s), HasSubstr("is at most pressure_limit"));
  s.composition.bodies[0].energy = -1;
  EXPECT_THAT(problems(s), HasSubstr("specific_internal_energy = -1 J/kg: must be 0 or more"));
}

// The temperature of a particle is that of its own material.
TEST(Bodies, AreAsHotAsTheirOwnMaterialSays) {
  mpm::Scene s = boxed(scenes::cavity(0.2e-6));
  s.composition.high = {2e-6, 4e-6, 0};
  s.other_materials = {mpm::named_material("tungsten")};
  s.other_materials[0].initial_temperature =
      500;  // the whole body is hotter than all that a weak shock heats
  s.composition.bodies = {{"cold", block({0, 0, 0}, {2e-6, 2e-6, 0}), 0, {0, -20, 0}},
                          {"hot", block({0, 2e-6, 0}, {2e-6, 4e-6, 0}), 1, {0, -20, 0}}};
  s.end_time = 0.2e-9;
  s.measures.area_every = s.end_time / 20;
  EXPECT_NEAR(mpm::run(s).find("hot_spot_temperature_K")->value, 500, 5);
}

TEST(Bodies, FlyFreelyBetweenOpenFaces) {
  for (const mpm::Kernel kernel : {mpm::Kernel::fast, mpm::Kernel::reference}) {
    mpm::Simulation simulation(flight(kernel));
    EXPECT_EQ(simulation.run().status, mpm::RunStatus::done);
    double x = 0, mass = 0;
    const auto& ps = simulation.state().particles;
    for (std::size_t p = 0; p < ps.size(); ++p) x += ps.mass[p] * ps.position[p].x(), mass += ps.mass[p];
    EXPECT_NEAR(x / mass, 6e-6, 1e-12);
  }
}

TEST(Bodies, EndARunWhereTheyReachAnOpenFace) {
  for (const mpm::Kernel kernel : {mpm::Kernel::fast, mpm::Kernel::reference})
    for (const Triple& velocity : {Triple{500, 0, 0}, Triple{-500, 0, 0}, Triple{0, -500, 0}}) {
      mpm::Scene s = flight(kernel);
      s.composition.bodies[0].velocity = velocity;
      s.end_time = 20e-9;
      const mpm::RunResult r = mpm::run(s);
      EXPECT_EQ(r.status, mpm::RunStatus::failed);
      EXPECT_THAT(r.reason, HasSubstr("a body has reached an open face of the box"));
    }
}

// A plan warns of what the cells do not show.
TEST(Bodies, HaveThinParts) {
  mpm::Scene s = flight(mpm::Kernel::fast);
  EXPECT_TRUE(mpm::thin_parts(s).empty());
  s.composition.bodies[0].shape = minus(ball({2e-6, 2e-6, 0}, 1e-6), ball({2e-6, 2e-6, 0}, 0.9e-6));
  ASSERT_EQ(mpm::thin_parts(s).size(), 1u);
  EXPECT_NEAR(mpm::thin_parts(s)[0].size, 0.1e-6, 1e-18);
  s.composition.bodies[0].shape =
      minus(ball({2e-6, 2e-6, 0}, 1e-6), block({1.9e-6, 0, 0}, {2.1e-6, 9e-6, 0}));
  EXPECT_NEAR(mpm::thin_parts(s).at(0).cells, 1, 1e-9);
}

// Figures show the image of a half.
TEST(Bodies, AreHalfOfASceneBesideAMirrorAtZero) {
  const auto is_half = [](const mpm::Scene& s) { return mpm::kind_of(s).is_half(s); };
  mpm::Scene s = flight(mpm::Kernel::fast);
  EXPECT_FALSE(is_half(s));
  face(s, Side::left) = Face::mirror;
  EXPECT_TRUE(is_half(s));
  s.composition.low[0] = -1e-6;
  EXPECT_FALSE(is_half(s));
}

TEST(Bodies, TurnAsTheirSpinSays) {
  mpm::Scene s = flight(mpm::Kernel::fast);
  s.composition.bodies[0].spin = 1e7;
  s.composition.bodies[0].about = {2e-6, 2e-6, 0};
  const mpm::State state = mpm::build_state(s);
  for (std::size_t p = 0; p < state.particles.size(); ++p) {
    const mpm::Vec2 arm = state.particles.position[p] - mpm::Vec2(2e-6, 2e-6);
    EXPECT_NEAR(state.particles.velocity[p].x(), 500 - 1e7 * arm.y(), 1e-9);
    EXPECT_NEAR(state.particles.velocity[p].y(), 1e7 * arm.x(), 1e-9);
  }
}

// Regions that are made of regions share them: neither depth nor number makes them slow or large.
TEST(Bodies, MayBeOfManyParts) {
  Shape deep = ball({0, 0, 0}, 1);
  for (int depth = 0; depth < 60; ++depth)
    deep = {Shape::Form::together, {}, {std::move(deep), ball({0, 0, 0}, 1)}};
  EXPECT_EQ(mpm::region_of<2>(deep).share_of_ball({0, 0}, 0.5), mpm::Share::all);
  Shape wide{Shape::Form::together, {}, {}};
  for (int k = 0; k < 3000; ++k) wide.parts.push_back(ball({3.0 * k, 0, 0}, 1));
  const auto region = mpm::region_of<2>(wide);
  EXPECT_EQ(region.share_of_ball({3.0 * 2999, 0}, 0.5), mpm::Share::all);
  EXPECT_EQ(region.high.x(), 3.0 * 2999 + 1);
}

TEST(Bodies, SayWhatIsWrong) {
  const mpm::Scene good = flight(mpm::Kernel::fast);
  EXPECT_EQ(problems(good), "");
  mpm::Scene s = good;
  s.composition.bodies.clear();
  EXPECT_THAT(problems(s), HasSubstr("body = none: must be a scene of one body or more"));
  s = good;
  s.composition.bodies.push_back(s.composition.bodies[0]);
  EXPECT_THAT(problems(s), HasSubstr("body ball = named twice"));
  s.composition.bodies[1].name = "other";
  EXPECT_THAT(problems(s), HasSubstr("two bodies overlap at x = "));
  s = good;
  s.composition.bodies[0].shape = ball({20e-6, 2e-6, 0}, 1e-6);
  EXPECT_THAT(problems(s), HasSubstr("body ball = a body lies outside of the grid"));
  s = good;
  s.composition.bodies[0].velocity = {};
  EXPECT_THAT(problems(s), HasSubstr("nothing moves"));
  s = good;
  s.composition.bodies[0].shape = {Shape::Form::cylinder, {0, 0, 0, 0, 1e-6, 0, 1e-6}, {}};
  EXPECT_THAT(problems(s), HasSubstr("shape = cylinder: must be a ball"));
  s = good;
  s.space = mpm::Space::axisymmetric;
  EXPECT_THAT(problems(s), HasSubstr("faces.left = open: must be \"mirror\" when space is"));
  EXPECT_THAT(problems(s), HasSubstr("along y, without a spin"));
  s = good;
  face(s, Side::right) = Face::wall;
  EXPECT_THAT(problems(s), HasSubstr("faces.right = wall"));
  s = good;
  face(s, Side::top) = Face::mirror;
  EXPECT_THAT(problems(s), HasSubstr("faces.top = mirror"));
  s = good;
  s.composition.high[0] = 0;
  EXPECT_THAT(problems(s), HasSubstr("box = (0, 4e-06) m: must be high above low"));
  s = good;
  s.composition.bodies[0].material = 1;
  EXPECT_THAT(problems(s), HasSubstr("body ball = material 1"));
}

}  // namespace
