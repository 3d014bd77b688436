// A study with a [surface], as a user runs it.
#include <nlohmann/json.hpp>

#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using Json = nlohmann::json;

TEST_F(Program, ASurfaceAddsTheSameRunsForAnyNumberOfWorkersAndAfterAStop) {
  const std::string study = SOURCE_DIR "/studies/examples/surface.toml";
  const auto go = [&](const std::string& folder_of_results, Arguments more) {
    Arguments arguments = {"run", study,       "--cells",        "1.5", "--set", "budget=16",
                           "-q",  "--results", folder_of_results};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  ASSERT_EQ(go(results, {"-j", "2"}), 0) << output;
  const auto decided = query(results, "SELECT key, position, reason FROM decisions ORDER BY position").rows;
  ASSERT_EQ(decided.size(), 16u);
  EXPECT_THAT(std::get<std::string>(decided[15][2]),
              ContainsRegex("^round 2 of the surface, where a run tells"));
  const std::string alone = (folder.path() / "alone").string();
  ASSERT_EQ(go(alone, {"-j", "1"}), 0) << output;
  EXPECT_EQ(query(alone, "SELECT key, position, reason FROM decisions ORDER BY position").rows, decided);
  // stopped after the design: the rest follows
  const std::string stopped = (folder.path() / "stopped").string();
  ASSERT_EQ(go(stopped, {"--set", "budget=8"}), 0) << output;
  EXPECT_EQ(query(stopped, "SELECT key FROM jobs").rows.size(), 8u);
  EXPECT_EQ(go(stopped, {"-n"}), 0);
  EXPECT_THAT(output, HasSubstr("surface: [surface] adds runs, 4 in a round, until 16 in all"));
  EXPECT_THAT(output, HasSubstr("4 jobs would run"));
  ASSERT_EQ(go(stopped, {}), 0) << output;
  EXPECT_THAT(output, HasSubstr("8 done, 0 failed, 8 reused"));
  EXPECT_EQ(rows_of(stopped), rows_of(results));
  // what it has come to, and what asks it
  EXPECT_EQ(run({"show", "surface", "--results", results}), 0);
  EXPECT_THAT(output,
              ContainsRegex("surface of collapsibility, tolerance (holds|does not hold): 16 runs of at most "
                            "16; a run would be within [0-9.]+ of it at [0-9]+ % of the places"));
  const Json surface = Json::parse(out("show surface --json"))["studies"][0]["surface"];
  EXPECT_EQ(surface["runs"], 16);
  EXPECT_EQ(surface["holds"], surface["share"] >= 0.9 && surface["runs"] >= 20);
  EXPECT_EQ(run({"predict", "surface", "--at", "impact_speed=250 m/s", "--at", "cavity_radius=1 um",
                 "--results", results}),
            0);
  EXPECT_THAT(output, HasSubstr("from 16 runs; each left out in turn"));
  const auto last = std::get<std::string>(decided[15][0]);
  EXPECT_EQ(run({"explain", last.substr(0, 12), "--results", results}), 0);
  EXPECT_THAT(output, HasSubstr("of surface: round 2 of the surface, where a run tells it most"));
  EXPECT_EQ(run({"plan", study, "--results", results}), 0);
  EXPECT_THAT(output, ContainsRegex(
                          "\\[surface\\] of collapsibility adds up to [0-9]+ runs where they tell it most"));
}

}  // namespace
}  // namespace mpmstudy
