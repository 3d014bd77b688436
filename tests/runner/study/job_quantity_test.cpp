// Times and limits that are expressions: snapshots, reductions and stops of each job.
#include <gmock/gmock.h>

#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const char* const timed = R"(
[measure]
snapshots = ["arrival", "2 * arrival + 0.5 ns", "1 ns"]
[[gauge]]
name = "rear"
of = "velocity_y"
point = ["1 um", "block_height"]
reduce = { plateau = "mean arrival to arrival + 1 ns", then = "at 2 * arrival", sum = "at 1 ns + 2 ns" }
[[stop]]
when = "rear > 1.5 * impact_speed"
after = "arrival"
)";
using Parameters = std::vector<std::pair<std::string, std::string>>;
const Parameters two_speeds = {{"impact_speed", R"(["100 m/s", "200 m/s"])"},
                               {"arrival", "\"block_height / (5 km/s + impact_speed)\""}};

TEST(NumbersOfJobs, FollowTheParametersOfEachJob) {
  const Study study = read_text(study_text(two_speeds, timed));
  ASSERT_EQ(study.scenes.size(), 2u);
  for (const mpm::Scene& scene : study.scenes) {
    const double arrival = 6e-6 / (5000 + scene.impact_speed);
    const auto close = [](double time) { return testing::DoubleNear(time, 1e-11 * time); };  // 12 digits
    EXPECT_THAT(scene.measures.snapshots,
                ElementsAre(close(1e-9), close(arrival), close(2 * arrival + 0.5e-9)));
    const mpm::Gauge& gauge = scene.measures.gauges.at(0);
    ASSERT_EQ(gauge.reductions.size(), 3u);
    EXPECT_EQ(gauge.reductions[0].name, "plateau");
    EXPECT_THAT(gauge.reductions[0].from, close(arrival));
    EXPECT_THAT(gauge.reductions[0].to, close(arrival + 1e-9));
    EXPECT_DOUBLE_EQ(gauge.reductions[1].from, 3e-9);
    EXPECT_THAT(gauge.reductions[2].from, close(2 * arrival));
    EXPECT_EQ(gauge.reductions[2].from, gauge.reductions[2].to);
    ASSERT_EQ(gauge.stops.size(), 1u);
    EXPECT_DOUBLE_EQ(gauge.stops[0].value, 1.5 * scene.impact_speed);
    EXPECT_THAT(gauge.stops[0].after, close(arrival));
  }
}

TEST(NumbersOfJobs, AreTheSameTimeWhereTheyDifferByRounding) {
  const Study study = read_text(study_text({{"end_time", "\"4 ns\""}, {"t0", "\"1 ns\""}},
                                           "[measure]\nsnapshots = [\"t0\", \"0.1*t0 + 0.2*t0 + 0.7*t0\", "
                                           "\"3 ns - 1 ns\", \"0.1*end_time*3*(10/3)\"]\n"));
  EXPECT_THAT(study.scenes.at(0).measures.snapshots, ElementsAre(1e-9, 2e-9, 4e-9));
}

TEST(NumbersOfJobs, SayWhatIsWrongWithThem) {
  const auto problems = [&](const std::string& from, const std::string& to) {
    std::string text = timed;
    text.replace(text.find(from), from.size(), to);
    return problems_of(study_text(two_speeds, text));
  };
  EXPECT_THAT(problems("2 * arrival + 0.5 ns", "block_height"), HasSubstr("is a quantity in m"));
  EXPECT_THAT(problems("mean arrival to", "mean arival to"), HasSubstr("did you mean \"arrival\""));
  EXPECT_THAT(problems("mean arrival to", "mean 3 * arrival to"),
              HasSubstr("first time not after the second"));
  EXPECT_THAT(problems("at 2 * arrival", "at 20 * arrival"), HasSubstr("up to end_time"));
  EXPECT_THAT(problems("1.5 * impact_speed", "1.5 * arrival"), HasSubstr("is a quantity in s"));
  EXPECT_THAT(problems("2 * arrival + 0.5 ns", "20 * arrival"), HasSubstr("after the end of the run"));
  EXPECT_THAT(problems("2 * arrival + 0.5 ns", "arrival - 2 ns"), HasSubstr("negative"));
}

}  // namespace
}  // namespace mpmstudy
