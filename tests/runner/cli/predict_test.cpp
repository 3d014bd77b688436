// predict and sensitivity, on the example of a map: 24 runs over two parameters.
#include <fstream>
#include <nlohmann/json.hpp>

#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class Predict : public Program {
 protected:
  Predict() {
    EXPECT_EQ(run({"run", SOURCE_DIR "/studies/examples/map.toml", "-q", "--results", results}), 0) << output;
  }
};

TEST_F(Predict, SaysTheRunsThatItHasAndOthersWithAnInterval) {
  // at a run
  const auto run = query(results,
                         "SELECT impact_speed_m_s, cavity_radius_m, collapsibility FROM jobs WHERE study = "
                         "'map' ORDER BY position LIMIT 1")
                       .rows.at(0);
  const Json there = Json::parse(out("predict map --of collapsibility --json --at impact_speed='" +
                                     std::to_string(std::get<double>(run[0])) + " m/s' --at cavity_radius='" +
                                     std::to_string(1e6 * std::get<double>(run[1])) + " um'"));
  const Json& at_run = there["predictions"][0]["collapsibility"];
  EXPECT_NEAR(at_run["value"], std::get<double>(run[2]), 0.05);
  // and where a run that is made afterwards is
  ASSERT_EQ(this->run({"run", SOURCE_DIR "/studies/examples/map.toml", "-q", "--results", results, "--set",
                       "name=check", "--set", "samples=2", "--set", "seed=5"}),
            0)
      << output;
  for (const auto& row : query(results,
                               "SELECT impact_speed_m_s, cavity_radius_m, collapsibility FROM jobs WHERE "
                               "study = 'check'")
                             .rows) {
    std::ofstream(folder.path() / "points.csv")
        << "impact_speed [km/s],cavity_radius [um]\n"
        << std::get<double>(row[0]) / 1e3 << "," << std::get<double>(row[1]) * 1e6 << "\n";
    const std::string csv =
        out("predict map --of collapsibility --points '" + (folder.path() / "points.csv").string() + "'");
    ASSERT_EQ(code, 0);
    EXPECT_THAT(csv,
                testing::StartsWith("impact_speed [m/s],cavity_radius [m],collapsibility,collapsibility_low,"
                                    "collapsibility_high,outside\n"));
    double speed, radius, value;
    ASSERT_EQ(std::sscanf(csv.c_str() + csv.find('\n'), "%lf,%lf,%lf", &speed, &radius, &value), 3) << csv;
    EXPECT_NEAR(value, std::get<double>(row[2]), 0.15);
  }
}

TEST_F(Predict, SaysWhatIsMissingAndWhatIsOutside) {
  out("predict map --at impact_speed='200 m/s'");
  EXPECT_EQ(code, 2);
  EXPECT_EQ(run({"predict", "map", "--at", "impact_speed=200 m/s", "--results", results}), 2);
  EXPECT_THAT(output, HasSubstr("--at: the surface is over more; missing: cavity_radius (0.5"));
  EXPECT_EQ(run({"predict", "map", "--at", "impact_sped=200 m/s", "--results", results}), 2);
  EXPECT_THAT(
      output,
      HasSubstr(
          "--at: impact_sped = \"200 m/s\": no such swept parameter of map; did you mean \"impact_speed\"?"));
  EXPECT_EQ(run({"predict", "map", "--at", "impact_speed=200 um", "--at", "cavity_radius=1 um", "--results",
                 results}),
            2);
  EXPECT_THAT(output, HasSubstr("'um' is not a unit of"));
  EXPECT_EQ(run({"predict", "map", "--at", "impact_speed=900 m/s", "--at", "cavity_radius=1 um", "--results",
                 results}),
            0);
  EXPECT_THAT(output, HasSubstr("impact_speed = 900 m/s is outside of the runs: impact_speed (1"));
  EXPECT_THAT(output, HasSubstr("from 24 runs; each left out in turn: error "));
  EXPECT_EQ(run({"predict", "map", "--of", "colapsibility", "--results", results}), 2);
  EXPECT_THAT(output, HasSubstr("--of: colapsibility: no such result; did you mean \"collapsibility\"?"));
}

TEST_F(Predict, SensitivityNamesWhatMatters) {
  const Json json = Json::parse(out("sensitivity map --of collapsibility --json"));
  const Json& parameters = json["results"][0]["parameters"];
  for (const char* name : {"impact_speed", "cavity_radius"}) {
    const Json& first = parameters[name]["first"];
    EXPECT_LE(first["low"], first["value"]);
    EXPECT_GE(first["high"], first["value"]);
  }
  EXPECT_GT(parameters["impact_speed"]["total"]["value"], parameters["cavity_radius"]["total"]["value"]);
  EXPECT_GT(parameters["impact_speed"]["rank_correlation"], 0.3);
  const Json& effect = parameters["impact_speed"]["main_effect"];
  ASSERT_EQ(effect.size(), 9u);
  EXPECT_GT(effect[8]["value"], effect[0]["value"]) << "a faster impact closes more of the cavity";
  EXPECT_GT(effect[8]["at"], effect[0]["at"]);
  const std::string text = out("sensitivity map --of collapsibility");
  EXPECT_THAT(text, HasSubstr("inputs as the study draws them"));
  EXPECT_THAT(text, testing::ContainsRegex("impact_speed .* 0\\.[0-9]+ at 106 m/s, [0-9.]+ at 394 m/s"));
}

}  // namespace
}  // namespace mpmstudy
