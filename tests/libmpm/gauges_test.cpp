// Gauges of a scene against exact states and against the balances of the run.
#include "libmpm/measure/gauges.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "libmpm/body/fill.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::Gauge;
using mpm::GaugeTarget;
using mpm::Window;

constexpr double um = 1e-6, ns = 1e-9;

/// A plate of 10 um at 1120 m/s: the shock is at the middle after 0.73 ns and at the rear after 1.46 ns; the
/// release comes back to the middle after 2 ns.
mpm::Scene plate() {
  mpm::Scene s = scenes::planar(1120, 10 * um, 0.1 * um, 2.4 * ns);
  s.measures.area_every = s.end_time / 120;
  return s;
}

Gauge at_middle(std::string name, std::string of, GaugeTarget target) {
  return {.name = std::move(name),
          .of = std::move(of),
          .target = target,
          .place = {0.2 * um, 5 * um},
          .reductions = {{"plateau", Window::mean, 1.1 * ns, 1.5 * ns}}};
}

Gauge of_body(std::string name, std::string of) {
  return {.name = std::move(name), .of = std::move(of), .target = GaugeTarget::body};
}

/// Every gauge that the tests ask.
std::vector<Gauge> all_gauges(int axes) {
  std::vector<Gauge> all = {at_middle("pressure", "pressure", GaugeTarget::point),
                            at_middle("stress", "stress_yy", GaugeTarget::point),
                            at_middle("temperature", "temperature", GaugeTarget::point),
                            at_middle("where", "position_y", GaugeTarget::point),
                            at_middle("speed", "velocity_y", GaugeTarget::point),
                            at_middle("density", "density", GaugeTarget::place),
                            {.name = "rear",
                             .of = "velocity_y",
                             .target = GaugeTarget::beam,
                             .place = {0, 12 * um},
                             .reductions = {{"pull", Window::mean, 1.8 * ns, 2.2 * ns}}},
                            {.name = "push", .of = "force", .target = GaugeTarget::wall},
                            of_body("mass", "mass"),
                            of_body("momentum", "momentum_y"),
                            of_body("drift", "velocity_y"),
                            of_body("centre", "center_y"),
                            of_body("kinetic", "kinetic_energy"),
                            of_body("internal", "internal_energy"),
                            of_body("length", "length_y"),
                            of_body("top", "highest_y")};
  for (Gauge& gauge : all)
    if (axes == 3 && !gauge.place.empty()) gauge.place.push_back(0.1 * um);
  return all;
}

const mpm::History& history(const mpm::RunResult& r, const char* name) {
  const mpm::History* found = r.history(name);
  if (!found) throw std::logic_error(std::string("no history ") + name);
  return *found;
}

/// "gauge.a.of = ...: must be ..." of each problem.
std::vector<std::string> problems(const mpm::Scene& s) {
  std::vector<std::string> lines;
  for (const mpm::Problem& p : mpm::find_problems(s))
    lines.push_back(p.parameter + " = " + p.value + ": " + p.allowed);
  return lines;
}

/// What the gauges of a plate have to read, in any space and by any kernel.
void expect_exact(const mpm::Scene& s, const mpm::RunResult& r) {
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  const auto solid = scenes::exact_solid(s.material);
  const auto exact = mpm::verification::exact::elastic_plastic_impact(solid, s.impact_speed);
  const auto value = [&](const char* name) { return scenes::metric(r, name); };
  EXPECT_NEAR(value("pressure.plateau") / exact.pressure, 1, 0.01);
  EXPECT_NEAR(value("stress.plateau") / -exact.normal_stress, 1, 0.01);
  EXPECT_NEAR(value("density.plateau") / exact.density, 1, 0.01);
  EXPECT_NEAR(value("speed.plateau") / s.impact_speed, 0, 0.005) << "behind the shock it is at rest";
  EXPECT_NEAR(value("speed.min") / -s.impact_speed, 1, 1e-9) << "until the shock comes it falls";
  const double free = mpm::verification::exact::simple_release(solid, exact).surface_speed - s.impact_speed;
  EXPECT_NEAR(value("rear.pull") / free, 1, 0.02);
  EXPECT_EQ(history(r, "rear").values.front(), -s.impact_speed);

  // A material point is where it was, compressed towards the wall; its velocity is that of its place.
  const mpm::History &where = history(r, "where"), &speed = history(r, "speed");
  EXPECT_NEAR(where.values.front() / (5 * um), 1, 1e-12);
  double way = 0;
  for (std::size_t k = 1; k < where.times.size(); ++k)
    way += 0.5 * (speed.values[k] + speed.values[k - 1]) * (where.times[k] - where.times[k - 1]);
  EXPECT_NEAR(where.values.back() - where.values.front(), way, 0.01 * std::abs(way));

  // Bodies: energy is kept, and the wall gives what the momentum gains.
  const mpm::History &kinetic = history(r, "kinetic"), &internal = history(r, "internal");
  ASSERT_EQ(kinetic.times, internal.times);
  double mass = history(r, "mass").values.front();
  EXPECT_NEAR(kinetic.values.front() / (0.5 * mass * s.impact_speed * s.impact_speed), 1, 1e-12);
  for (std::size_t k = 0; k < kinetic.values.size(); ++k)
    EXPECT_NEAR((kinetic.values[k] + internal.values[k]) / kinetic.values[0], 1, 1e-9);
  const mpm::History &push = history(r, "push"), &momentum = history(r, "momentum");
  ASSERT_EQ(push.times.size() + 1, momentum.times.size()) << "no force at time 0";
  double impulse = 0;
  for (std::size_t k = 0; k < push.times.size(); ++k) {
    EXPECT_EQ(push.times[k], momentum.times[k + 1]);
    impulse += push.values[k] * (momentum.times[k + 1] - momentum.times[k]);
    EXPECT_NEAR(impulse, momentum.values[k + 1] - momentum.values[0], 1e-9 * mass * s.impact_speed);
    EXPECT_NEAR(history(r, "drift").values[k] * mass, momentum.values[k], 1e-12 * mass * s.impact_speed);
  }
  EXPECT_GT(impulse, mass * s.impact_speed) << "it comes back up";
  EXPECT_NEAR(history(r, "centre").values.front() / (5 * um), 1, 1e-9);
  EXPECT_NEAR(history(r, "length").values.front() / (10 * um), 1, 1e-9);
  EXPECT_NEAR(history(r, "top").values.front() / (10 * um), 1, 1e-9);
  EXPECT_LT(value("length.min"), 9 * um);
}

TEST(Gauges, ReadTheExactStateByBothKernels) {
  for (const auto kernel : {mpm::Kernel::fast, mpm::Kernel::reference}) {
    SCOPED_TRACE(kernel == mpm::Kernel::fast ? "fast" : "reference");
    mpm::Scene s = plate();
    s.numerics.kernel = kernel;
    s.measures.gauges = all_gauges(2);
    expect_exact(s, mpm::run(s));
  }
}

TEST(Gauges, ReadTheExactStateInEverySpace) {
  for (const auto space : {mpm::Space::axisymmetric, mpm::Space::three_d}) {
    SCOPED_TRACE(space == mpm::Space::three_d ? "three-d" : "axisymmetric");
    mpm::Scene s = scenes::in_space(space, plate());
    s.measures.gauges = all_gauges(mpm::axes_of(space));
    expect_exact(s, mpm::run(s));
  }
}

TEST(Gauges, SayTheirUnits) {
  mpm::Scene s = plate();
  s.end_time = s.measures.area_every = 0.01 * ns;
  const auto units = [&](mpm::Space space) {
    mpm::Scene there = scenes::in_space(space, s);
    there.measures.gauges = all_gauges(mpm::axes_of(space));
    for (Gauge& gauge : there.measures.gauges) gauge.reductions.clear();
    std::string text;
    const mpm::RunResult r = mpm::run(there);
    for (const char* name : {"pressure", "rear", "push", "mass", "momentum", "kinetic"}) {
      text += history(r, name).unit + " ";
      EXPECT_EQ(r.find(std::string(name) + ".end")->unit, history(r, name).unit);
    }
    return text;
  };
  EXPECT_EQ(units(mpm::Space::plane_strain), "Pa m/s N/m kg/m kg/s J/m ");
  EXPECT_EQ(units(mpm::Space::axisymmetric), "Pa m/s N/rad kg/rad kg m/s/rad J/rad ");
  EXPECT_EQ(units(mpm::Space::three_d), "Pa m/s N kg kg m/s J ");
}

TEST(Gauges, AreSampledAtTheTimesOfTheRunAndChangeNothing) {
  mpm::Scene s = plate();
  const mpm::RunResult without = mpm::run(s);
  EXPECT_TRUE(without.histories.empty());
  s.measures.gauges = all_gauges(2);
  const mpm::RunResult with = mpm::run(s);
  ASSERT_EQ(with.histories.size(), s.measures.gauges.size());
  EXPECT_EQ(history(with, "mass").times.size(), 121u);
  EXPECT_EQ(history(with, "mass").times.front(), 0);
  EXPECT_EQ(history(with, "mass").times.back(), s.end_time);
  for (const mpm::Metric& metric : without.metrics)
    EXPECT_EQ(with.find(metric.name)->value, metric.value) << metric.name;
}

// Where the beam passes over no material, and where a place is empty, there is nothing to record.
TEST(Gauges, LeaveOutWhatIsNotThere) {
  mpm::Scene s = scenes::cavity(0.2 * um);
  s.measures.gauges = {
      {.name = "hole", .of = "pressure", .target = GaugeTarget::place, .place = {0, 1.9 * um}},
      {.name = "roof",
       .of = "position_y",
       .target = GaugeTarget::beam,
       .place = {0, 1.9 * um},
       .direction = "+y"},
      {.name = "floor", .of = "position_y", .target = GaugeTarget::beam, .place = {0, 1.9 * um}},
      {.name = "over", .of = "speed", .target = GaugeTarget::beam, .place = {0, 9 * um}, .direction = "+y"}};
  const mpm::RunResult r = mpm::run(s);
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_TRUE(history(r, "hole").times.empty());
  EXPECT_TRUE(history(r, "over").times.empty());
  EXPECT_FALSE(r.find("over.max")) << "a number that the run does not have";
  // of a hole of 1.5 um around 1.9 um, to half a cell
  EXPECT_NEAR(history(r, "roof").values.front(), 3.4 * um, 0.15 * um);
  EXPECT_NEAR(history(r, "floor").values.front(), 0.4 * um, 0.15 * um);
  EXPECT_LT(history(r, "roof").values.back(), history(r, "roof").values.front()) << "it collapses";
}

TEST(Gauges, OfATurningBodyReadItsSpin) {
  constexpr double rate = 1e6, cell = 0.1 * um;
  mpm::Scene s = scenes::cavity(cell);
  s.end_time = s.measures.area_every = 0.01 * ns;
  s.measures.gauges = {of_body("spin", "spin"), of_body("right", "highest_x"), of_body("left", "lowest_x"),
                       of_body("v", "velocity_x")};
  mpm::State disc = mpm::empty_state({-3 * um, 0}, {cell, cell}, 60);
  const mpm::Vec2 center(0, 3 * um);
  const auto turning = [&](const mpm::Vec2& x) -> mpm::Vec2 {
    return {50 - rate * (x - center).y(), rate * (x - center).x()};
  };
  mpm::fill(disc, {mpm::disc(center, 1 * um), turning}, s);
  const mpm::RunResult r = mpm::Simulation(s, disc).run();
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_NEAR(history(r, "spin").values.front() / rate, 1, 1e-12);
  EXPECT_NEAR(history(r, "v").values.front(), 50, 1e-9);
  EXPECT_NEAR(history(r, "right").values.front(), 1 * um, cell);
  EXPECT_NEAR(history(r, "left").values.front(), -1 * um, cell);
}

/// A small plate falls onto a large one, which is at rest, between mirrors; the floor is far below.
mpm::Scene two_plates() {
  mpm::Scene s = scenes::planar(400, 10 * um, 0.2 * um, 1 * ns);
  s.kind = mpm::SceneKind::bodies;
  s.numerics = mpm::default_numerics(s.kind);
  s.numerics.cell_size = 0.2 * um;
  mpm::Composition& all = s.composition;
  all.high = {2 * um, 12 * um, 0};
  using enum mpm::Face;
  all.faces = {mirror, mirror, wall, open, mirror, mirror};
  const auto plate = [](double low, double high) {
    return mpm::Shape{mpm::Shape::Form::block, {0, low, 0, 2 * um, high, 0}, {}};
  };
  all.bodies = {{"anvil", plate(2 * um, 8 * um)}, {"flyer", plate(8 * um, 11 * um)}};
  all.bodies[1].velocity = {0, -400, 0};
  return s;
}

TEST(Gauges, OfOneBodyOfSeveralReadThatOne) {
  mpm::Scene s = two_plates();
  s.measures.gauges = {
      of_body("flyer", "momentum_y"),
      of_body("anvil", "momentum_y"),
      of_body("all", "momentum_y"),
      of_body("mass", "mass"),
      of_body("foot", "lowest_y"),
      {.name = "below", .of = "velocity_y", .target = GaugeTarget::point, .place = {1 * um, 7.99 * um}}};
  s.measures.gauges[0].body = s.measures.gauges[3].body = s.measures.gauges[4].body = "flyer";
  s.measures.gauges[1].body = "anvil";
  const mpm::RunResult r = mpm::run(s);
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  const auto &flyer = history(r, "flyer").values, &anvil = history(r, "anvil").values;
  EXPECT_NEAR(history(r, "mass").values[0] / (2700 * 2 * um * 3 * um), 1, 1e-9);
  EXPECT_NEAR(flyer[0] / (-400 * history(r, "mass").values[0]), 1, 1e-12);
  EXPECT_EQ(anvil[0], 0);
  for (std::size_t k = 0; k < flyer.size(); ++k)
    EXPECT_NEAR((flyer[k] + anvil[k]) / flyer[0], 1, 1e-9) << "what one loses the other gets";
  EXPECT_LT(anvil.back(), 0.5 * flyer[0]) << "a lighter plate gives all of it, sooner or later";
  EXPECT_EQ(history(r, "all").values[0], flyer[0]);
  EXPECT_NEAR(history(r, "foot").values[0], 8 * um, 1e-12);
  EXPECT_EQ(history(r, "below").values[0], 0) << "a point of the anvil, next to the flyer";
}

TEST(Gauges, AreReducedBetweenSamples) {
  const mpm::History h{"a", "1", {0, 1, 2, 4}, {0, 2, 0, 4}};
  const auto of = [&](Window window, double from, double to) {
    return mpm::reduced(h, {"r", window, from, to}).value_or(-1);
  };
  EXPECT_EQ(of(Window::mean, 0.5, 0.5), 1);
  EXPECT_EQ(of(Window::mean, 4, 4), 4);
  EXPECT_EQ(of(Window::mean, 0, 4), (1 + 1 + 4) / 4.0);
  EXPECT_EQ(of(Window::mean, 0.5, 1.5), (0.75 + 0.75));
  EXPECT_EQ(of(Window::largest, 0.5, 3), 2);
  EXPECT_EQ(of(Window::smallest, 0.5, 3), 0);
  EXPECT_EQ(of(Window::smallest, 2.5, 3), 1);
  EXPECT_EQ(of(Window::mean, 3, 5), -1) << "beyond the end";
  EXPECT_FALSE(mpm::reduced({"a", "1", {}, {}}, {"r", Window::mean, 0, 0}));
}

class Threads : public mpm::Observer {
 public:
  int threads() override { return 2; }
};

TEST(Gauges, EndARunAtTheFirstSampleBeyondAThreshold) {
  const mpm::History h{"a", "1", {0, 1, 2}, {1, 0.5, -0.5}};
  EXPECT_EQ(mpm::time_beyond(h, {true, 0, 0}), 1.5);
  EXPECT_EQ(mpm::time_beyond(h, {true, 0, 1.75}), 1.75);
  EXPECT_EQ(mpm::time_beyond(h, {true, 0.75, 0}), 2) << "it was below before";
  EXPECT_TRUE(std::isinf(mpm::time_beyond(h, {true, 0, 2.5})));
  EXPECT_TRUE(std::isinf(mpm::time_beyond(h, {false, 0, 0})));

  mpm::Scene s = plate();
  s.measures.gauges = all_gauges(2);
  for (Gauge& gauge : s.measures.gauges)
    if (gauge.name == "rear") gauge.stops = {{false, 0, 0}, {true, -1e9, 0}};
  ASSERT_THAT(problems(s), testing::ElementsAre());
  const mpm::RunResult r = mpm::run(s);
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  const mpm::History& rear = history(r, "rear");
  const std::size_t n = rear.values.size();
  ASSERT_LT(n, 100u) << "the shock is at the rear after 1.46 of 2.4 ns";
  EXPECT_GT(rear.values[n - 1], 0);
  EXPECT_LE(rear.values[n - 2], 0);
  EXPECT_EQ(history(r, "mass").times, rear.times) << "the run ends there, each sample once";
  ASSERT_TRUE(r.find("rear.stop"));
  EXPECT_EQ(r.find("rear.stop")->unit, "s");
  EXPECT_GT(r.find("rear.stop")->value, rear.times[n - 2]);
  EXPECT_LE(r.find("rear.stop")->value, rear.times[n - 1]);
  EXPECT_NEAR(r.find("rear.stop")->value, 1.46 * ns, 0.06 * ns);
  EXPECT_FALSE(r.find("rear.pull")) << "its window was not reached";
  EXPECT_FALSE(r.find("push.stop"));

  // Later: the threshold is passed already.
  for (Gauge& gauge : s.measures.gauges)
    if (gauge.name == "rear") gauge.stops = {{false, 0, 2 * ns}};
  const mpm::RunResult later = mpm::run(s);
  EXPECT_NEAR(scenes::metric(later, "rear.stop"), 2 * ns, s.measures.area_every);
}

TEST(Gauges, HaveTheSameBitsOnTwoThreads) {
  mpm::Scene s = scenes::cavity(0.04 * um);
  s.impact_speed = 1120;
  s.end_time = 0.1 * ns;
  s.measures.area_every = 0.02 * ns;
  s.measures.gauges = all_gauges(2);
  for (Gauge& gauge : s.measures.gauges) {
    gauge.reductions.clear();
    if (gauge.target != GaugeTarget::beam && !gauge.place.empty()) gauge.place = {4 * um, 0.3 * um};
  }
  const mpm::RunResult one = mpm::run(s);
  mpm::RunResult two;
  for (int tries = 0; two.helper_seconds == 0 && tries < 100; ++tries) {
    Threads threads;
    two = mpm::run(s, threads);
  }
  EXPECT_GT(two.helper_seconds, 0);
  for (std::size_t g = 0; g < one.histories.size(); ++g) {
    EXPECT_FALSE(one.histories[g].values.empty()) << one.histories[g].name;
    EXPECT_EQ(one.histories[g].values, two.histories[g].values) << one.histories[g].name;
  }
}

TEST(Gauges, ThatAreWrongAreRefused) {
  using testing::ElementsAre;
  using testing::StartsWith;
  mpm::Scene s = scenes::cavity(0.2 * um);
  const auto with = [&](Gauge gauge) {
    s.measures.gauges = {std::move(gauge)};
    return problems(s);
  };
  const Gauge good{.name = "a", .of = "pressure", .target = GaugeTarget::point, .place = {2 * um, 4 * um}};
  EXPECT_THAT(with(good), ElementsAre());
  const auto changed = [&](auto change) {
    Gauge gauge = good;
    change(gauge);
    return with(gauge);
  };
  EXPECT_THAT(changed([](Gauge& g) { g.name = "a.b"; }),
              ElementsAre("gauge.a.b.name = a.b: up to 60 letters, digits, '-' and '_'"));
  EXPECT_THAT(changed([](Gauge& g) { g.of = "velocity_z"; }),
              ElementsAre(StartsWith("gauge.a.of = velocity_z: velocity_x, velocity_y, density, ")));
  EXPECT_THAT(changed([](Gauge& g) {
                g.place = {0, 1.9e-6};
              }),
              ElementsAre("gauge.a.point = (0, 1.9e-06) m: inside a body at time 0"));
  EXPECT_THAT(changed([](Gauge& g) {
                g.place = {0, 5.1e-6};
              }),
              ElementsAre("gauge.a.point = (0, 5.1e-06) m: inside a body at time 0"));
  EXPECT_THAT(changed([](Gauge& g) {
                g.place = {0, 4e-6, 0};
              }),
              ElementsAre("gauge.a.point = (0, 4e-06, 0) m: two coordinates, x and y"));
  EXPECT_THAT(
      changed([](Gauge& g) {
        g.target = GaugeTarget::place, g.place = {6e-6, 0};
      }),
      ElementsAre(
          "gauge.a.place = (6e-06, 0) m: in what is modelled: x from the left side (0 m) to the right "
          "side (5e-06 m)"));
  EXPECT_THAT(changed([](Gauge& g) { g.target = GaugeTarget::beam, g.direction = "+z"; }),
              ElementsAre("gauge.a.direction = +z: +x, -x, +y, -y"));
  EXPECT_THAT(changed([](Gauge& g) { g.target = GaugeTarget::body, g.of = "mass", g.body = "anvil"; }),
              ElementsAre("gauge.a.body = anvil: all"));
  EXPECT_THAT(changed([](Gauge& g) { g.target = GaugeTarget::wall, g.of = "force", g.wall = "top"; }),
              ElementsAre("gauge.a.wall = top: bottom"));
  EXPECT_THAT(changed([](Gauge& g) {
                g.stops = {{true, 0, 2 * ns}};
              }),
              ElementsAre("gauge.a.after = 2e-09 s: from 0 s on and before end_time (1e-09 s)"));
  EXPECT_THAT(changed([](Gauge& g) {
                g.reductions = {{"max", Window::mean, 0, 2 * ns}};
              }),
              ElementsAre("gauge.a.reduce.max = max: a name of its own, and not max, min, end or stop",
                          "gauge.a.reduce.max = 0 s to 2e-09 s: up to end_time (1e-09 s)"));
  mpm::Scene bodies = two_plates();
  const auto of_bodies = [&](Gauge gauge) {
    bodies.measures.gauges = {std::move(gauge)};
    return problems(bodies);
  };
  Gauge whose = of_body("a", "mass"), push{.name = "a", .of = "force", .target = GaugeTarget::wall},
        in = good;
  whose.body = "bar";
  EXPECT_THAT(of_bodies(whose), ElementsAre("gauge.a.body = bar: all, anvil, flyer"));
  in.place = {1 * um, 10 * um};
  EXPECT_THAT(of_bodies(in), ElementsAre());
  in.place = {1e-6, 11.5e-6};
  EXPECT_THAT(of_bodies(in), ElementsAre("gauge.a.point = (1e-06, 1.15e-05) m: inside a body at time 0"));
  EXPECT_THAT(of_bodies(push), ElementsAre());
  bodies.composition.faces[3] = mpm::Face::mirror;
  bodies.numerics.kernel = mpm::Kernel::reference;
  EXPECT_THAT(of_bodies(push),
              ElementsAre("gauge.a.wall = bottom: of a scene that is open above: its force is "
                          "not told from that of the top"));
  bodies.composition.faces[2] = mpm::Face::open;
  EXPECT_THAT(of_bodies(push),
              ElementsAre("gauge.a.wall = bottom: a wall that is there: the bottom is open"));
  s.measures.gauges = {good, good};
  EXPECT_THAT(problems(s), ElementsAre("gauge.a.name = a: of one gauge only"));
  s.space = mpm::Space::axisymmetric;
  s.numerics = mpm::default_numerics(s.kind, s.space);
  s.numerics.cell_size = 0.2 * um;
  EXPECT_THAT(with(of_body("a", "spin")), ElementsAre(StartsWith("gauge.a.of = spin: mass, center_x, ")));
}

}  // namespace
