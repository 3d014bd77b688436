// `bench exact`: the ladder as a user calls it. What the numbers must be is held by tests/verification.
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

class BenchExact : public Program {
 protected:
  std::vector<nlohmann::json> rows(Arguments arguments) {
    arguments.insert(arguments.begin(), {"bench", "exact", "--json"});
    EXPECT_EQ(run(arguments), 0) << output;
    std::vector<nlohmann::json> all;
    std::istringstream text(output);
    for (std::string line; std::getline(text, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  }
};

TEST_F(BenchExact, has_every_problem_of_the_ladder) {
  ASSERT_EQ(run({"bench", "exact", "--problem", "nothing"}), 2);
  for (const char* name : {"hugoniot",
                           "uniaxial-path",
                           "release",
                           "bauschinger",
                           "planar-20",
                           "planar-200",
                           "planar-1120",
                           "planar-1500",
                           "planar-3000",
                           "surface-history",
                           "shell-131",
                           "shell-185",
                           "shell-225",
                           "shell-255",
                           "shell-131-hardening",
                           "shell-185-hardening",
                           "shell-225-hardening",
                           "shell-255-hardening",
                           "axis-aligned",
                           "vortex",
                           "vibrating-bar",
                           "elastic-disks",
                           "scale",
                           "half-and-full",
                           "wall-and-two-bodies",
                           "moving-frame"})
    EXPECT_THAT(output, ContainsRegex(std::string("[{,]") + name + "[,}]"));
}

TEST_F(BenchExact, prints_one_line_a_number) {
  ASSERT_EQ(run({"bench", "exact", "--problem", "hugoniot", "--problem", "bauschinger"}), 0) << output;
  EXPECT_THAT(output, StartsWith("problem "));
  EXPECT_THAT(output, ContainsRegex("hugoniot +pressure at 1120 m/s +20.6924 GPa +20.6924 GPa .*yes"));
  EXPECT_THAT(output,
              ContainsRegex("bauschinger +fall of q to reverse yield, kinematic 1 +240 MPa +240 MPa"));
  EXPECT_THAT(output, HasSubstr("10 of 10 numbers hold, 2 problems"));
  ASSERT_EQ(run({"bench", "exact", "--problem", "hugoniot", "--csv"}), 0);
  EXPECT_THAT(output,
              StartsWith("problem,quantity,unit,exact,ours,error,judged,tolerance,holds,problem_cpu_s\n"));
  EXPECT_THAT(output, ContainsRegex("hugoniot,\"pressure at 1120 m/s\",Pa,"));
}

TEST_F(BenchExact, json_has_a_verdict_and_what_it_rests_on) {
  const auto all = rows({"--problem", "planar-20", "hugoniot", "--cells", "4", "-j", "2"});
  ASSERT_EQ(all.size(), 7u + 9u);
  EXPECT_EQ(all[0].at("problem"), "hugoniot");  // in the order of the ladder
  EXPECT_EQ(all[7].at("problem"), "planar-20");
  EXPECT_NEAR(all[7].at("exact").get<double>(), 334.07e6, 1e3);
  for (const auto& r : all) {
    EXPECT_EQ(r.at("holds").get<bool>(), r.at("error").get<double>() <= r.at("tolerance").get<double>());
    EXPECT_GE(r.at("problem_cpu_s").get<double>(), 0);
  }
}

TEST_F(BenchExact, cells_and_schemes_change_what_is_computed) {
  const auto ours = [&](Arguments more) {
    more.insert(more.begin(), {"--problem", "planar-1120"});
    return rows(more).at(0).at("ours").get<double>();
  };
  const double coarse = ours({"--cells", "4"});
  EXPECT_NE(ours({"--cells", "3"}), coarse);
  EXPECT_NE(ours({"--cells", "4", "--scheme", "bspline2"}), coarse);
  EXPECT_NE(ours({"--cells", "4", "--particles-per-cell", "4"}), coarse);
}

TEST_F(BenchExact, refuses_what_is_not_there) {
  EXPECT_EQ(run({"bench", "exact", "--scheme", "nothing"}), 2);
  EXPECT_THAT(output, HasSubstr("bspline2"));
  EXPECT_EQ(run({"bench", "exact", "--particles-per-cell", "5"}), 2);
  EXPECT_EQ(run({"bench", "exact", "--cells", "0"}), 2);
  EXPECT_EQ(run({"bench", "exact", "--json", "--csv"}), 2);
}

TEST_F(BenchExact, has_a_lagrangian_code_beside_it) {
  const std::string file = std::string(SOURCE_DIR) + "/studies/paper/weak-collapse.toml";
  ASSERT_EQ(run({"bench", "lagrangian", file, "--per-radius", "4"}), 0) << output;
  EXPECT_THAT(output,
              StartsWith("job,cells_per_radius,collapsibility,order,energy_error,stop_time_s,stopped\n"));
  EXPECT_THAT(output, ContainsRegex(",16,0\\.7[0-9]+,,[0-9.]+e-1[0-9],,\n"));
  EXPECT_THAT(output, ContainsRegex(",limit,0\\.7[0-9]+,1\\.[0-9]+,,,\n"));
  ASSERT_EQ(
      run({"bench", "lagrangian", file, "--per-radius", "4", "--history", "--set", "impact_speed=500 m/s"}),
      0);
  EXPECT_THAT(output, StartsWith("job,cells_per_radius,time_s,area_m2\n"));
  ASSERT_EQ(run({"bench", "lagrangian", std::string(SOURCE_DIR) + "/studies/paper/planar-impact.toml"}), 2);
  EXPECT_THAT(output, HasSubstr("takes blocks with a cavity"));
}

}  // namespace
}  // namespace mpmstudy
