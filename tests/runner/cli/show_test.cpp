// show, and run --json: numbers for people and for programs.
#include <fstream>
#include <nlohmann/json.hpp>

#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

class Show : public Program {
 protected:
  std::string study = SOURCE_DIR "/tests/faults/kill.toml", quoted = "'" + study + "'";
};

TEST_F(Show, run_and_show_give_one_object_with_the_numbers_of_the_catalog) {
  const Json ran = Json::parse(out("run " + quoted + " --json"));
  EXPECT_EQ(code, 0);
  EXPECT_EQ(ran["exit_code"], 0);
  const Json& jobs = ran["studies"][0]["jobs"];
  const auto rows =
      query(results,
            "SELECT key, impact_speed_m_s, cavity_radius_m, collapsibility, collapsibility_error, outcome "
            "FROM jobs WHERE study = 'kill' ORDER BY position")
          .rows;
  ASSERT_EQ(jobs.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(jobs[i]["key"], std::get<std::string>(rows[i][0]));
    EXPECT_EQ(jobs[i]["impact_speed_m_s"], std::get<double>(rows[i][1]));
    EXPECT_EQ(jobs[i]["cavity_radius_m"], std::get<double>(rows[i][2]));
    EXPECT_EQ(jobs[i]["collapsibility"], std::get<double>(rows[i][3]));
    EXPECT_EQ(jobs[i]["collapsibility_error"], std::get<double>(rows[i][4]));
    EXPECT_EQ(jobs[i]["outcome"], std::get<std::string>(rows[i][5]));
    EXPECT_EQ(jobs[i]["status"], "done");
  }
  // by name and by file, without running anything
  for (const std::string& named : {std::string("kill"), quoted})
    EXPECT_EQ(Json::parse(out("show " + named + " --json")), ran) << named;
}

TEST_F(Show, prints_what_run_has_printed) {
  const std::string ran = out("run " + quoted);
  const std::string shown = out("show kill");
  EXPECT_EQ(code, 0);
  EXPECT_THAT(shown, HasSubstr("kill: "));
  EXPECT_THAT(shown, HasSubstr("collapsibility"));
  EXPECT_THAT(ran, HasSubstr(shown));
}

TEST_F(Show, says_what_is_not_there) {
  out("run " + quoted + " -q");
  EXPECT_EQ(run({"show", "kull", "--results", results}), 2);
  EXPECT_THAT(output, HasSubstr("kull: no such file, and no study of the catalog; it has: kill"));
  EXPECT_EQ(run({"show", study, "--set", "impact_speed=250 m/s", "--results", results}), 75) << output;
}

TEST_F(Show, a_search_has_its_brackets) {
  const std::string file = (folder.path() / "search.toml").string();
  std::ofstream(file) << R"(schema = 1
name = "search"
scene = "cavity-impact"
[parameters]
material = "aluminium"
block_width = "6 um"
block_height = "5 um"
cavity_radius = "1 um"
wall_thickness = "0.5 um"
end_time = "3 ns"
[numerics]
cell_size = "0.25 um"
[search]
critical = "impact_speed"
outcome = "ejected"
between = ["200 m/s", "2000 m/s"]
tolerance = "600 m/s"
)";
  const Json ran = Json::parse(out("run '" + file + "' --json"));
  ASSERT_EQ(ran["studies"][0]["brackets"].size(), 1u) << ran.dump(2);
  const std::string shown = out("show search");
  EXPECT_THAT(shown, HasSubstr("impact_speed ")) << shown;
  EXPECT_THAT(shown, HasSubstr(" m/s to ")) << shown;
}

}  // namespace
}  // namespace mpmstudy
