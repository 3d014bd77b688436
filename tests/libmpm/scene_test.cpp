// What a scene may be, how it is cut into particles, and what comes out of a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "libmpm/scene/build.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using testing::HasSubstr;

std::string first_problem(const mpm::Scene& s) {
  const auto problems = mpm::find_problems(s);
  return problems.empty() ? "" : problems[0].parameter + ": " + problems[0].allowed;
}

TEST(FindProblems, NamesWhatIsWrong) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  EXPECT_EQ(first_problem(s), "");
  s.cavity_center_height = 1.4e-6;
  EXPECT_THAT(first_problem(s), HasSubstr("leaves the block below"));
  s.cavity_center_height = 3.6e-6;
  EXPECT_THAT(first_problem(s), HasSubstr("leaves the block above"));
  s = scenes::cavity(0.1e-6);
  s.cavity_radius = 5e-6;
  EXPECT_THAT(first_problem(s), HasSubstr("as wide as the block"));
  s = scenes::cavity(0.1e-6);
  s.cavity_radius = 0.05e-6;
  EXPECT_THAT(first_problem(s), HasSubstr("smaller than a cell"));
  s = scenes::cavity(0.1e-6);
  s.numerics.particles_per_cell = 5;
  EXPECT_EQ(first_problem(s), "particles_per_cell: 1, 4, 9 or 16");
  s = scenes::cavity(0.1e-6);
  s.impact_speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(first_problem(s), "impact_speed: a finite number");
  s = scenes::cavity(0.1e-6);
  s.material.yield_stress = std::numeric_limits<double>::infinity();
  EXPECT_EQ(first_problem(s), "");
}

TEST(FindProblems, SizesBeyondReasonAreASlipOfTheUnit) {
  mpm::Scene s = scenes::cavity(1e-30);
  EXPECT_THAT(first_problem(s), HasSubstr("at most 1e9 particles"));
  s = scenes::cavity(0.1e-6);
  s.end_time = 1e300;
  EXPECT_THAT(first_problem(s), HasSubstr("at most 1e9 steps"));
  s = scenes::cavity(0.1e-6);
  s.measures.area_every = 1e-30;
  EXPECT_THAT(first_problem(s), HasSubstr("a millionth of end_time"));
}

TEST(FindProblems, SchemesThatTheFastStepLacksNeedTheReference) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.numerics.scheme = mpm::ShapeFunction::cpdi;
  EXPECT_THAT(first_problem(s), HasSubstr("kernel: \"reference\""));
  s.numerics.kernel = mpm::Kernel::reference;
  EXPECT_EQ(first_problem(s), "");
  s.numerics.pic_fraction = 1.5;
  EXPECT_EQ(first_problem(s), "pic_fraction: from 0 to 1");
  s.numerics.pic_fraction = 0.1;
  s.numerics.transfer = mpm::Transfer::apic;
  EXPECT_EQ(first_problem(s), "pic_fraction: 0 with transfer = \"apic\"");
}

TEST(FindProblems, ATangentCavityIsFine) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  s.cavity_center_height = s.cavity_radius;
  EXPECT_EQ(first_problem(s), "");
}

TEST(Run, ThrowsOnBadInputBeforeTheFirstStep) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  s.cavity_radius = -1;
  EXPECT_THROW(mpm::run(s), mpm::InputError);
}

TEST(Build, MassIsThatOfTheBlockWithoutTheCavity) {
  for (const int ppc : {1, 4, 9, 16}) {
    mpm::Scene s = scenes::cavity(0.1e-6);
    s.numerics.particles_per_cell = ppc;
    const mpm::State state = mpm::build_state(s);
    double mass = 0;
    for (const double m : state.particles.mass) mass += m;
    const double exact = 2700 * (5e-6 * 5e-6 - 0.5 * std::numbers::pi * 1.5e-6 * 1.5e-6);
    EXPECT_NEAR(mass / exact, 1, 2e-4) << ppc;
  }
}

TEST(Build, EstimateIsCloseToTheRun) {
  const mpm::Scene s = scenes::cavity(0.2e-6);
  const mpm::Estimate e = mpm::estimate(s);
  const mpm::RunResult r = mpm::run(s);
  EXPECT_NEAR(static_cast<double>(e.particles) / r.particles, 1, 0.05);
  EXPECT_NEAR(static_cast<double>(e.steps) / r.steps, 1, 0.15);
}

/// Counts what an observer is told, and stops when asked to.
struct Watcher : mpm::Observer {
  std::int64_t steps = 0, stop_at = -1;
  std::vector<double> areas, snapshots;
  std::size_t columns = 0;
  bool on_step(const mpm::Progress& p) override {
    ++steps;
    EXPECT_EQ(p.step, steps);
    return steps != stop_at;
  }
  void on_area(const mpm::AreaSample& a) override { areas.push_back(a.time); }
  void on_snapshot(const mpm::Snapshot& s) override {
    snapshots.push_back(s.time);
    columns = s.temperature.size();
  }
};

TEST(Run, TellsTheObserverAndHitsTheTimesExactly) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.measures.snapshots = {0.0, 0.123e-9, 1e-9};
  Watcher w;
  const mpm::RunResult r = mpm::run(s, w);
  EXPECT_EQ(r.status, mpm::RunStatus::done);
  EXPECT_EQ(w.steps, r.steps);
  EXPECT_EQ(w.snapshots, s.measures.snapshots);
  EXPECT_EQ(static_cast<std::int64_t>(w.columns), r.particles);
  ASSERT_EQ(w.areas.size(), 21u);
  for (std::size_t k = 0; k < w.areas.size(); ++k) EXPECT_DOUBLE_EQ(w.areas[k], k * 0.05e-9);
  EXPECT_EQ(r.area_history.size(), w.areas.size());
}

// 0.7 ns and 7 times 0.1 ns differ by rounding: one event, not two with a step of 1e-25 s between them.
TEST(Run, TakesNoTinySteps) {
  struct Steps : mpm::Observer {
    double smallest = 1;
    bool on_step(const mpm::Progress& p) override {
      smallest = std::min(smallest, p.time_step);
      return true;
    }
  } steps;
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.measures.area_every = 0.1e-9;
  s.measures.snapshots = {0.3e-9, 0.6e-9, 0.7e-9};
  mpm::run(s, steps);
  EXPECT_GT(steps.smallest, 1e-12);
}

TEST(Run, StopsWhenTheObserverSaysSo) {
  Watcher w;
  w.stop_at = 3;
  const mpm::RunResult r = mpm::run(scenes::cavity(0.2e-6), w);
  EXPECT_EQ(r.status, mpm::RunStatus::stopped);
  EXPECT_EQ(r.steps, 3);
}

TEST(Run, BreakdownIsAResult) {
  mpm::Scene s = scenes::planar(20000, 2e-6, 0.1e-6, 1e-9);  // far beyond the equation of state
  const mpm::RunResult r = mpm::run(s);
  EXPECT_EQ(r.status, mpm::RunStatus::failed);
  EXPECT_THAT(r.reason,
              HasSubstr("% of the mass is beyond the equation of state, pressure_limit = 2.7e+11 Pa"));
}

// The wall is kept as a difference of lengths; what was written comes back.
TEST(Parameters, AWallHasTheThicknessThatWasWritten) {
  const mpm::Quantity& wall = *mpm::find_quantity("wall_thickness");
  mpm::Scene scene;
  for (const double height : {4e-6, 6e-6, 11e-6, 1e-3})
    for (const double radius : {1e-6, 1.5e-6, 0.7e-6})
      for (const double thickness : {1e-6, 0.5e-6, 0.07e-6, 1.25e-6, 0.123456e-6, 0.0}) {
        scene.block_height = height;
        scene.cavity_radius = radius;
        wall.set(scene, thickness);
        EXPECT_EQ(wall.get(scene), thickness) << height << ' ' << radius;
      }
  scene.block_height = 5e-6;
  scene.cavity_radius = 1e-6;
  scene.cavity_center_height = 3e-6;
  EXPECT_EQ(wall.get(scene), 1e-6);
  scene.cavity_center_height = 4.5e-6;  // out of the block: find_problems says so
  EXPECT_EQ(wall.get(scene), -0.5e-6);
}

// The empty rows for the way of two bodies are counted in floating point, too.
TEST(FindProblems, TwoBodiesThatGoTooFarAreRefused) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.kind = mpm::SceneKind::two_body_impact;
  s.impact_speed = 1e6;
  s.end_time = 0.01;
  s.measures.area_every = s.end_time / 100;
  const auto problems = mpm::find_problems(s);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].parameter, "end_time");
  EXPECT_THAT(problems[0].allowed, testing::HasSubstr("at most 1e9 cells"));
}

// What no integer counts is no undefined number.
TEST(Parameters, EstimatesOfAbsurdScenesAreLargeNumbers) {
  mpm::Scene scene = scenes::cavity(0.2e-6);
  scene.impact_speed = 1e300;
  EXPECT_GT(mpm::estimate(scene).steps, std::int64_t(1) << 62);
}

}  // namespace
