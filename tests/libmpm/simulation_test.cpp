// A run taken step by step, stopped, and made of parts of one's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/scene/build.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/step/reference_stepper.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using testing::HasSubstr;

void expect_same(const mpm::RunResult& a, const mpm::RunResult& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.final_area, b.final_area);
  EXPECT_EQ(a.area_history.size(), b.area_history.size());
  ASSERT_EQ(a.metrics.size(), b.metrics.size());
  for (std::size_t i = 0; i < a.metrics.size(); ++i)
    EXPECT_EQ(a.metrics[i].value, b.metrics[i].value) << a.metrics[i].name;
}

TEST(Simulation, StepByStepIsTheWholeRun) {
  const mpm::Scene scene = scenes::cavity(0.4e-6);
  mpm::Simulation simulation(scene);
  std::int64_t steps = 1;
  while (simulation.step()) ++steps;
  EXPECT_FALSE(simulation.step());
  EXPECT_EQ(simulation.time(), scene.end_time);
  const mpm::RunResult whole = mpm::run(scene);
  EXPECT_EQ(steps, whole.steps);
  expect_same(simulation.result(), whole);
}

TEST(Simulation, AskingOnTheWayChangesNothing) {
  const mpm::Scene scene = scenes::cavity(0.4e-6);
  mpm::Simulation simulation(scene);
  for (int k = 0; k < 20; ++k) simulation.step();
  const mpm::RunResult part = simulation.result();
  EXPECT_EQ(part.status, mpm::RunStatus::stopped);
  EXPECT_EQ(part.reason, "its end is not reached");
  EXPECT_EQ(part.steps, 20);
  EXPECT_LT(*part.final_area, *part.initial_area);
  simulation.state();
  expect_same(simulation.run(), mpm::run(scene));
}

struct StopsAfter : mpm::Observer {
  explicit StopsAfter(std::int64_t s) : steps(s) {}
  bool on_step(const mpm::Progress& p) override { return p.step != steps; }
  std::int64_t steps;
};

TEST(Simulation, ARunThatIsStoppedHasWhatItMeasured) {
  const mpm::Scene scene = scenes::cavity(0.4e-6);
  const mpm::RunResult whole = mpm::run(scene);
  for (const std::int64_t at : {std::int64_t{1}, whole.steps / 2}) {
    StopsAfter observer(at);
    const mpm::RunResult r = mpm::run(scene, observer);
    EXPECT_EQ(r.status, mpm::RunStatus::stopped);
    EXPECT_EQ(r.reason, "stopped by the observer");
    EXPECT_EQ(r.steps, at);
    ASSERT_TRUE(r.final_area && r.collapsibility && r.collapsibility_error);
    EXPECT_TRUE(std::isfinite(*r.final_area) && std::isfinite(*r.collapsibility_error));
    EXPECT_EQ(r.outcome, "partial");
    EXPECT_EQ(*r.initial_area, *whole.initial_area);
    EXPECT_GE(r.area_history.size(), 2u);
    EXPECT_LT(r.energy_error, 1e-12);
    ASSERT_TRUE(r.find("largest_cfl") && r.find("new_cavities") && r.find("hot_spot_temperature_K"));
    EXPECT_FALSE(r.find("no such thing"));
  }
}

// Every kind of measurement, stopped before it has seen anything.
TEST(Simulation, AStopInTheFirstStepBreaksNoMeasurement) {
  for (const mpm::Scene& scene : {scenes::planar(500, 4e-6, 0.1e-6, 1e-9), scenes::shell(185, 0.3e-6)}) {
    StopsAfter observer(1);
    const mpm::RunResult r = mpm::run(scene, observer);
    EXPECT_EQ(r.status, mpm::RunStatus::stopped);
    for (const mpm::Metric& m : r.metrics) EXPECT_TRUE(std::isfinite(m.value)) << m.name;
  }
}

/// Counts its calls.
struct Calls {
  int steps = 0, samples = 0;
};
class Counts : public mpm::Measurement {
 public:
  explicit Counts(Calls& calls) : calls_(calls) {}
  void after_step(const mpm::State&, const mpm::StepReport&, double) override { ++calls_.steps; }
  void sample(const mpm::State&, mpm::Observer&) override { ++calls_.samples; }
  void finish(const mpm::State&, mpm::RunResult& r) const override {
    r.metrics.push_back({"counted", static_cast<double>(calls_.steps), "1", {}});
  }
  void carry(mpm::Archive&) override {}

 private:
  Calls& calls_;
};

TEST(Simulation, TakesMeasurementsAndAStepperOfOnesOwn) {
  mpm::Scene scene = scenes::cavity(0.4e-6);
  Calls calls;
  mpm::Simulation simulation(scene);
  simulation.add(std::make_unique<Counts>(calls));
  simulation.use(std::make_unique<mpm::ReferenceStepper<mpm::BSpline2>>(mpm::build_material(scene)));
  const mpm::RunResult r = simulation.run();
  EXPECT_EQ(calls.steps, r.steps);
  EXPECT_EQ(calls.samples, 21);
  EXPECT_EQ(r.find("counted")->value, static_cast<double>(r.steps));
  EXPECT_THROW(simulation.add(std::make_unique<Counts>(calls)), std::logic_error);
  EXPECT_THROW(simulation.use(nullptr), std::logic_error);
  scene.numerics.kernel = mpm::Kernel::reference;
  EXPECT_EQ(r.final_area, mpm::run(scene).final_area);
}

TEST(Simulation, AStepOfAGivenLengthTakesNoSamples) {
  const mpm::Scene scene = scenes::cavity(0.4e-6);  // sampled every 50 ps
  Calls calls;
  mpm::Simulation simulation(scene);
  simulation.add(std::make_unique<Counts>(calls));
  const double dt = 10e-12;
  for (int k = 0; k < 12; ++k) EXPECT_TRUE(std::isfinite(simulation.step(dt).largest_signal));
  EXPECT_DOUBLE_EQ(simulation.time(), 12 * dt);
  EXPECT_EQ(calls.samples, 1);  // at the start
  EXPECT_EQ(simulation.run().status, mpm::RunStatus::done);
  EXPECT_EQ(calls.samples, 1 + 18);  // from 150 ps on
}

// ---------------------------------------------------------------- bodies of one's own

mpm::Vec2 falling(const mpm::Vec2&) { return {0, -200}; }

/// The block of scenes::cavity, made by hand.
mpm::State block(const mpm::Scene& s) {
  mpm::State state = mpm::empty_state({0, 0}, {0.2e-6, 0.2e-6}, 25);
  mpm::fill(
      state,
      {mpm::block({0, 0}, {5e-6, 5e-6}) - mpm::disc({0, s.cavity_center_height}, s.cavity_radius), falling},
      s);
  return state;
}

TEST(Simulation, ABodyMadeByHandDoesWhatTheSceneDoes) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  mpm::Simulation own(scene, block(scene)), kind(scene);
  const mpm::RunResult a = own.run(), b = kind.run();
  EXPECT_EQ(a.status, mpm::RunStatus::done);
  EXPECT_EQ(a.particles, b.particles);
  const mpm::Particles &mine = own.state().particles, &theirs = kind.state().particles;
  for (std::size_t p = 0; p < mine.size(); ++p)
    EXPECT_LT((mine.position[p] - theirs.position[p]).norm(), 1e-9 * 0.2e-6) << p;
  EXPECT_EQ(a.outcome, "");
  EXPECT_LT(a.energy_error, 1e-12);
}

TEST(Simulation, StateHasTheNodesOfTheLastStep) {
  for (const mpm::Kernel kernel : {mpm::Kernel::fast, mpm::Kernel::reference}) {
    mpm::Scene scene = scenes::cavity(0.2e-6);
    scene.numerics.kernel = kernel;
    mpm::Simulation simulation(scene);
    simulation.step();
    const mpm::State& s = simulation.state();
    double nodes = 0, particles = 0;
    for (int j = 0; j <= s.grid.rows() - 2; ++j)
      for (int i = 0; i <= s.grid.columns(); ++i) {
        const bool side = i == 0 || i == s.grid.columns();  // half of it is the image behind the mirror
        nodes += (side ? 0.5 : 1) * s.grid.at(i, j).mass;
      }
    for (const double m : s.particles.mass) particles += m;
    EXPECT_NEAR(nodes / particles, 1, 0.02);  // a little hangs below the wall
  }
}

std::string refusal(const mpm::Scene& scene, mpm::State body) {
  try {
    mpm::Simulation(scene, std::move(body));
  } catch (const mpm::InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Simulation, RefusesABodyThatCannotBeRun) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  EXPECT_EQ(refusal(scene, block(scene)), "");
  EXPECT_THAT(refusal(scene, mpm::empty_state({0, 0}, {0.2e-6, 0.2e-6}, 25)),
              HasSubstr("body = nothing: must be a body of at least one particle"));
  EXPECT_THAT(refusal(scene, mpm::empty_state({0, 0}, {0.2e-6, 0.2e-6}, 2)),
              HasSubstr("body = a grid of 2 cells across: must be in a grid of at least 3 cells"));
  mpm::State s = block(scene);
  s.particles.position[3].x() = 6e-6;
  EXPECT_THAT(refusal(scene, s), HasSubstr("particle 3 at x = 6e-06 m"));
  s = block(scene);
  s.particles.mass[3] = 0;
  EXPECT_THAT(refusal(scene, s), HasSubstr("of positive mass and volume"));
  s = block(scene);
  s.particles.energy.pop_back();
  EXPECT_THAT(refusal(scene, s), HasSubstr("must be one value for each of its"));
  mpm::Scene other = scene;
  other.numerics.cell_size = 1e-3;
  EXPECT_THAT(refusal(other, block(scene)),
              HasSubstr("about the smaller edge of the grid's cells (2e-07 m)"));
  other = scene;
  other.material.reference_density = 0;
  EXPECT_THAT(refusal(other, block(scene)), HasSubstr("reference_density = 0 kg/m3: must be more than 0"));
  other = scene;
  other.cavity_radius = other.block_width = 0;  // of the scene's own body, which is not asked for
  EXPECT_EQ(refusal(other, block(scene)), "");
}

TEST(Fill, KeepsTheMassOfCurvedRims) {
  const mpm::Scene s = scenes::cavity(0.1e-6);
  const mpm::Region region = (mpm::block({1e-6, 0}, {9e-6, 7e-6}) | mpm::disc({5e-6, 7e-6}, 2e-6)) -
                             (mpm::disc({3e-6, 2e-6}, 1e-6) | mpm::ellipse({5e-6, 4e-6}, {2e-6, 0.7e-6}) |
                              mpm::disc({3.5e-6, 2e-6}, 1e-6));
  mpm::State state = mpm::empty_state({0, 0}, {0.1e-6, 0.1e-6}, 100);
  mpm::fill(state, {region, falling}, s);
  double mass = 0;
  mpm::Vec2 moment(0, 0);
  for (std::size_t p = 0; p < state.particles.size(); ++p) {
    mass += state.particles.mass[p];
    moment += state.particles.mass[p] * state.particles.position[p];
  }
  // two discs of radius 1 whose centres are 1/2 apart
  const double lens = 2 * std::acos(0.25) - 0.25 * std::sqrt(4 - 0.25);
  const double pi = std::acos(-1.0);
  const double area = 8 * 7 + 2 * pi - (2 * pi - lens) - pi * 2 * 0.7;
  EXPECT_NEAR(mass / (2700 * area * 1e-12), 1, 2e-4);
  EXPECT_GT(moment.x() / mass, 5e-6);  // the holes on the left are gone
}

TEST(Fill, RefusesWhatOverlapsAndWhatHasNoEnd) {
  const mpm::Scene s = scenes::cavity(0.2e-6);
  mpm::State state = block(s);
  EXPECT_THROW(mpm::fill(state, {mpm::block({4e-6, 4e-6}, {5e-6, 6e-6}), falling}, s), mpm::InputError);
  state = block(s);
  mpm::fill(state, {mpm::block({4e-6, 5e-6}, {5e-6, 6e-6}), falling}, s);        // on top of it
  mpm::fill(state, {mpm::disc({0, s.cavity_center_height}, 1e-6), falling}, s);  // in the cavity
  EXPECT_EQ(refusal(s, state), "");
  EXPECT_THROW(mpm::fill(state, {mpm::everywhere(), falling}, s), mpm::InputError);
  EXPECT_THROW(mpm::fill(state, {mpm::disc({30e-6, 0}, 1e-6), falling}, s), mpm::InputError);
}

/// A slab of copper falls on one of aluminium that rests on a mirror; both are fluids, side by side between
/// mirrors: the state between the two shocks is that where both Hugoniots, one of them turned round, have one
/// pressure and one speed. Two bodies of one grid are welded, which in a planar impact is the exact
/// condition.
TEST(Simulation, ShocksOfTwoMaterialsMatchTheirImpedances) {
  using namespace mpm;
  constexpr double h = 1e-6, speed = 400;
  Scene settings;
  settings.material = named_material("aluminium-6061-t6");
  settings.other_materials = {named_material("copper")};
  settings.material.strength = settings.other_materials[0].strength = StrengthModel::none;
  settings.numerics = default_numerics(SceneKind::planar_impact);
  settings.numerics.cell_size = h;
  settings.end_time = 30e-9, settings.measures.area_every = 1e-9;
  for (const Kernel kernel : {Kernel::fast, Kernel::reference}) {
    settings.numerics.kernel = kernel;
    State body = empty_state({0, 0}, {h, h}, 4, Floor::mirror);
    const auto rest = [](const Vec2&) { return Vec2(0, 0); };
    const auto falling = [](const Vec2&) { return Vec2(0, -speed); };
    mpm::fill(body, Body{mpm::block({0, 0}, {4 * h, 250 * h}), rest}, settings, 0);
    mpm::fill(body, Body{mpm::block({0, 250 * h}, {4 * h, 500 * h}), falling}, settings, 1);
    EXPECT_THROW(mpm::fill(body, Body{mpm::block({0, 600 * h}, {4 * h, 610 * h}), rest}, settings, 0),
                 InputError);
    EXPECT_THROW(mpm::fill(body, Body{mpm::block({0, 600 * h}, {4 * h, 610 * h}), rest}, settings, 2),
                 InputError);
    Simulation simulation(settings, std::move(body));
    const RunResult result = simulation.run();
    ASSERT_EQ(result.status, RunStatus::done) << result.reason;
    EXPECT_LT(result.energy_error, 1e-12);

    // rho0 (c0 + lambda u) u of both
    const auto hugoniot = [](const Material& m, double u) {
      return m.reference_density * shock_speed(m, u) * u;
    };
    double low = 0, high = speed;
    for (int k = 0; k < 60; ++k) {
      const double u = 0.5 * (low + high);
      (hugoniot(settings.material, u) < hugoniot(settings.other_materials[0], speed - u) ? low : high) = u;
    }
    const double pressure = hugoniot(settings.material, low);
    // well inside both shocked layers, off the interface, whose wall heating is that of every such scheme
    const Particles& ps = simulation.state().particles;
    double sums[2] = {}, speeds[2] = {};
    int counts[2] = {};
    for (std::size_t p = 0; p < ps.size(); ++p) {
      const std::size_t m = ps.material_of(p);
      const double from_interface = ps.position[p].y() - (250 * h - low * simulation.time());
      if (std::abs(from_interface) < 20 * h || std::abs(from_interface) > 70 * h) continue;
      sums[m] += ps.pressure[p], speeds[m] -= ps.velocity[p].y(), ++counts[m];
    }
    for (int m = 0; m < 2; ++m) {
      ASSERT_GT(counts[m], 100);
      EXPECT_NEAR(sums[m] / counts[m] / pressure, 1, 0.005) << m;
      EXPECT_NEAR(speeds[m] / counts[m] / low, 1, 0.005) << m;
    }
  }
}

}  // namespace
