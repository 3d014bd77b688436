// [[gauge]] from the file to scenes, keys, text and back.
#include "runner/study/gauges.hpp"

#include <gmock/gmock.h>

#include "runner/plan/gauge_text.hpp"
#include "runner/plan/plan.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const char* const rear = R"(
[[gauge]]
name = "rear"
of = "velocity_y"
beam = ["1 um", "0.01 mm"]
direction = "-y"
reduce = { plateau = "mean 1 ns to 3 ns", arrived = "at 2000 ps", peak = "max 0 s to 1 ns" }
)";
const char* const push = R"(
[[gauge]]
name = "push"
of = "force"
wall = "bottom"
)";

mpm::Scene scene_of(const std::string& rest) { return read_text(study_text({}, rest)).scenes.at(0); }

TEST(GaugesOfAStudy, ReachEveryScene) {
  const Study study =
      read_text(study_text({{"cavity_radius", "[\"1 um\", \"1.5 um\"]"}}, std::string(rear) + push));
  ASSERT_EQ(study.scenes.size(), 2u);
  EXPECT_EQ(study.scenes[0].measures.gauges, study.scenes[1].measures.gauges);
  EXPECT_EQ(study.scenes[0].measures.gauges, study.gauges);
  ASSERT_EQ(study.gauges.size(), 2u);
  EXPECT_EQ(study.gauges[0],
            (mpm::Gauge{.name = "push", .of = "force", .target = mpm::GaugeTarget::wall, .wall = "bottom"}));
  EXPECT_EQ(study.gauges[1], (mpm::Gauge{.name = "rear",
                                         .of = "velocity_y",
                                         .target = mpm::GaugeTarget::beam,
                                         .place = {1e-6, 1e-5},
                                         .reductions = {{"arrived", mpm::Window::mean, 2e-9, 2e-9},
                                                        {"peak", mpm::Window::largest, 0, 1e-9},
                                                        {"plateau", mpm::Window::mean, 1e-9, 3e-9}}}));
  EXPECT_THAT(metrics_of(study.gauges),
              ElementsAre("push.max", "push.min", "push.end", "rear.max", "rear.min", "rear.end",
                          "rear.arrived", "rear.peak", "rear.plateau"));
}

TEST(GaugesOfAStudy, EndRuns) {
  const char* const stops = R"(
[[stop]]
when = "rear > 0.1 km/s"
[[stop]]
when = "push<0 N/m"
after = "2 ns"
)";
  const Study study = read_text(study_text({}, std::string(stops) + rear + push));
  EXPECT_EQ(study.gauges[0].stops, (std::vector<mpm::Threshold>{{true, 0, 2e-9}}));
  EXPECT_EQ(study.gauges[1].stops, (std::vector<mpm::Threshold>{{false, 100, 0}}));
  EXPECT_EQ(study.scenes[0].measures.gauges, study.gauges);
  EXPECT_THAT(metrics_of(study.gauges), testing::Contains("push.stop"));
}

TEST(GaugesOfAStudy, ArePartOfAJobsKeyAndTheirOrderIsNot) {
  EXPECT_EQ(job_key(scene_of(std::string(rear) + push)), job_key(scene_of(std::string(push) + rear)));
  const mpm::Scene scene = scene_of(std::string(rear) + push);
  std::set<std::string> keys = {job_key(scene), job_key(scene_of("")), job_key(scene_of(push))};
  EXPECT_EQ(keys.size(), 3u);
  const auto other = [&](auto change) {
    mpm::Scene changed = scene;
    change(changed.measures.gauges[1]);
    EXPECT_TRUE(keys.insert(job_key(changed)).second) << canonical_text(changed);
  };
  other([](mpm::Gauge& g) { g.name = "front"; });
  other([](mpm::Gauge& g) { g.of = "speed"; });
  other([](mpm::Gauge& g) { g.target = mpm::GaugeTarget::place; });
  other([](mpm::Gauge& g) { g.place[0] = 0; });
  other([](mpm::Gauge& g) { g.direction = "+y"; });
  other([](mpm::Gauge& g) { g.reductions.pop_back(); });
  other([](mpm::Gauge& g) { g.reductions[0].name = "there"; });
  other([](mpm::Gauge& g) { g.stops = {{true, 1, 2}}; });
  other([](mpm::Gauge& g) { g.stops = {{false, 1, 2}}; });
  other([](mpm::Gauge& g) { g.stops = {{true, 2, 2}}; });
  other([](mpm::Gauge& g) { g.stops = {{true, 1, 1}}; });
  other([](mpm::Gauge& g) { g.reductions[0].window = mpm::Window::smallest; });
  other([](mpm::Gauge& g) { g.reductions[0].to = 3e-9; });
  other([](mpm::Gauge& g) { g.target = mpm::GaugeTarget::body, g.body = "bar"; });
  other([](mpm::Gauge& g) { g.target = mpm::GaugeTarget::body, g.body = "anvil"; });
  other([](mpm::Gauge& g) { g.target = mpm::GaugeTarget::wall, g.wall = "top"; });
}

TEST(GaugesOfAStudy, ComeBackFromTheirTextWithAllBits) {
  std::vector<mpm::Gauge> gauges = scene_of(std::string(rear) + push).measures.gauges;
  gauges[1].place[0] = 1.0 / 3e6;
  gauges[0].stops = {{true, 1.0 / 3, 0}, {false, 7, 1e-9 / 3}};
  gauges.push_back({.name = "bar", .of = "mass", .target = mpm::GaugeTarget::body, .body = "bar"});
  gauges.push_back(
      {.name = "p", .of = "pressure", .target = mpm::GaugeTarget::point, .place = {0, 5e-324, 1}});
  EXPECT_EQ(gauges_from_text(gauges_text(gauges)), gauges);
  EXPECT_EQ(gauges_text({}), "[]");
  for (const char* wrong :
       {"", "[1]", R"([{"name": "a", "of": "b"}])", R"([{"name": "a", "of": "b", "point": "c"}])"})
    EXPECT_THROW(gauges_from_text(wrong), std::invalid_argument) << wrong;
}

TEST(GaugesOfAStudy, AreResultsOfFitsFiguresAndAccuracies) {
  const Study study =
      read_text(study_text({{"impact_speed", "[\"200 m/s\", \"300 m/s\"]"}}, std::string(rear) + R"(
[[fit]]
x = "impact_speed"
y = "rear.plateau"
model = "linear"
[[figure]]
name = "a"
kind = "history"
y = "rear"
[[figure]]
name = "b"
kind = "history"
[[figure]]
name = "c"
kind = "xy"
x = "impact_speed"
y = "rear.max"
)"));
  EXPECT_EQ(study.fits[0].y, "rear.plateau");
  EXPECT_EQ(study.figures[0].y, "rear");
  EXPECT_EQ(study.figures[1].y, "");
  EXPECT_EQ(study.figures[2].y, "rear.max");
}

TEST(GaugesOfAStudy, MayBeWhatAnAccuracyIsOf) {
  std::string text = study_text({}, rear);
  const std::string cell = "cell_size = \"0.1 um\"";
  ASSERT_NE(text.find(cell), std::string::npos) << text;
  text.replace(text.find(cell), cell.size(), "accuracy = \"5 %\"\naccuracy_of = \"rear.plateau\"");
  const Study study = read_text(text);
  EXPECT_EQ(study.ladder.quantity, "rear.plateau");
  EXPECT_EQ(study.ladder.unit, "m/s");
  text.replace(text.find("rear.plateau\"\n"), 12, "rear.plattau");
  try {
    read_text(text);
    ADD_FAILURE();
  } catch (const StudyError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"rear.plateau\"?"));
  }
}

// Units are of the study's own gauges: another study may have one of that name.
TEST(Gauges, HaveTheUnitsOfTheirOwnScenes) {
  mpm::Scene speed, mass, of_axis;
  mpm::Gauge gauge;
  gauge.name = "g";
  gauge.target = mpm::GaugeTarget::body;
  gauge.body = "all";
  gauge.of = "velocity_y";
  speed.measures.gauges = {gauge};
  gauge.of = "mass";
  mass.measures.gauges = of_axis.measures.gauges = {gauge};
  of_axis.space = mpm::Space::axisymmetric;
  EXPECT_EQ(unit_of_gauge({&speed}, "g.max"), "m/s");
  EXPECT_EQ(unit_of_gauge({&mass}, "g.max"), "kg/m");
  EXPECT_EQ(unit_of_gauge({&mass, &of_axis}, "g.max"), "kg/m or kg/rad");
  EXPECT_EQ(unit_of_gauge({&mass}, "h.max"), "");
}

}  // namespace
}  // namespace mpmstudy
