// What `run` ends with: tables of results, as a reader finds them under the lines of the jobs.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "runner/catalog/query.hpp"
#include "runner/cli/run.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/finish/finish_study.hpp"
#include "runner/status/label.hpp"
#include "runner/study/characters.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class ResultsText : public testing::Test {
 protected:
  /// A study of aluminium whose radii and other keys are given.
  void write(const std::string& radii, const std::string& more = "",
             const std::string& speed = "\"200 m/s\"") {
    std::ofstream(folder.path() / "t.toml")
        << "schema = 1\nname = \"t\"\ntitle = \"A test\"\nscene = \"cavity-impact\"\n[parameters]\n"
        << "material = \"aluminium\"\nimpact_speed = " << speed
        << "\nblock_width = \"10 um\"\nblock_height = \"6 um\"\ncavity_center_height = \"3 um\"\n"
        << "cavity_radius = " << radii << "\nend_time = \"1 ns\"\n[numerics]\ncell_size = \"0.5 um\"\n"
        << more;
  }
  int run() {
    RunOptions options;
    options.files = {(folder.path() / "t.toml").string()};
    options.results = (folder.path() / "results").string();
    options.quiet = quiet;
    RunSeams seams{simulate, fakes::write_snapshot,
                   [](const Study& study, const std::filesystem::path& results, CatalogWriter& writer) {
                     finish_study(study, results, writer);
                   }};
    testing::internal::CaptureStdout();
    const int code = run_run(options, seams);
    output = testing::internal::GetCapturedStdout();
    return code;
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> all;
    std::istringstream text(output);
    for (std::string line; std::getline(text, line);) all.push_back(line);
    return all;
  }
  /// From the title of the study on.
  std::string table() const { return output.substr(std::min(output.find("t: A test"), output.size())); }

  fakes::TemporaryFolder folder;
  Simulate simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    auto result = fakes::simulate(s, o);
    result.collapsibility = 0.1 + 1e5 * s.cavity_radius;
    result.collapsibility_error = 0.0123456;
    result.outcome = "partial";
    return result;
  };
  bool quiet = false;
  std::string output;
};

const std::string fit = "[[fit]]\nx = \"cavity_radius\"\ny = \"collapsibility\"\nmodel = \"linear\"\n";

TEST_F(ResultsText, a_row_has_what_is_swept_the_result_its_interval_and_the_outcome) {
  write("{ values = [1000, 1500, 2000], unit = \"nm\" }", fit);
  for (const char* when : {"the first time", "with nothing to do"}) {
    EXPECT_EQ(run(), 0) << when;
    EXPECT_THAT(table(), HasSubstr("+- is the measuring error on these cells only")) << when;
    EXPECT_THAT(table(), ContainsRegex("  job +cavity_radius +collapsibility +\\+- +outcome\n +nm\n"))
        << when;
    EXPECT_THAT(table(), ContainsRegex("  [0-9a-f]{12} +1000 +0.2 +0.0123 +partial\n")) << when;
    EXPECT_THAT(table(), ContainsRegex("  [0-9a-f]{12} +1500 +0.25 +0.0123 +partial\n")) << when;
    EXPECT_THAT(table(), HasSubstr("  linear of collapsibility against cavity_radius: Φ = ")) << when;
    EXPECT_THAT(table(), HasSubstr("R in µm")) << when;
  }
  quiet = true;
  EXPECT_EQ(run(), 0);
  EXPECT_EQ(table(), "");
}

TEST_F(ResultsText, gauges_show_their_reductions_or_what_they_end_with) {
  write("\"1 um\"",
        "[[gauge]]\nname = \"push\"\nof = \"force\"\nwall = \"bottom\"\n[[gauge]]\nname = \"rear\"\nof = "
        "\"velocity_y\"\n"
        "point = [\"1 um\", \"6 um\"]\nreduce = { mid = \"at 0.5 ns\" }\n");
  simulate = [](const mpm::Scene& s, mpm::Observer& o) { return mpm::run(s, o); };  // which has histories
  ASSERT_EQ(run(), 0) << output;
  EXPECT_THAT(output, HasSubstr("push.end"));
  EXPECT_THAT(output, HasSubstr("rear.mid"));
  EXPECT_THAT(output, Not(HasSubstr("rear.end")));
}

TEST_F(ResultsText, numbers_with_a_flag_are_marked_and_a_line_says_why) {
  write("[\"1 um\", \"1.5 um\", \"2 um\"]", fit);
  simulate = [good = simulate](const mpm::Scene& s, mpm::Observer& o) {
    auto result = good(s, o);
    if (s.cavity_radius > 1.6e-6) result.collapsibility_error = 5.9;
    return result;
  };
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(table(), ContainsRegex("  [0-9a-f]{12} +1\\.5 +0\\.25  +0\\.0123 +partial\n"));
  EXPECT_THAT(table(), ContainsRegex("  [0-9a-f]{12} +2 +0\\.3\\* +5\\.9 +partial\\*\n"));
  EXPECT_THAT(table(),
              HasSubstr("  * interval as wide as what a collapsibility can be (0 to 1): the final area "
                        "has no meaning, 1 job\n"));
  EXPECT_THAT(table(), HasSubstr("r² not judged (2 points, 2 coefficients)"));
}

TEST_F(ResultsText, a_fit_that_cannot_be_made_is_told_by_the_exit_code) {
  write("[\"1 um\", \"2 um\"]",
        "[[fit]]\nx = \"cavity_radius\"\ny = \"collapsibility\"\nmodel = \"quadratic\"\n");
  for (const char* when : {"the first time", "with nothing to do"}) {
    EXPECT_EQ(run(), exit_failed) << when;
    EXPECT_THAT(table(), HasSubstr("quadratic of collapsibility against cavity_radius: no fit, ")) << when;
  }
}

TEST_F(ResultsText, a_figure_of_which_nothing_is_left_is_told_by_the_exit_code) {
  const std::string figure =
      "[[figure]]\nname = \"f\"\nkind = \"xy\"\nx = \"cavity_radius\"\ny = \"collapsibility\"\n";
  write("[\"1 um\", \"2 um\"]", figure);
  EXPECT_EQ(run(), 0);
  write("[\"1.1 um\", \"1.9 um\"]", figure);
  simulate = [good = simulate](const mpm::Scene& s, mpm::Observer& o) {
    auto result = good(s, o);
    result.collapsibility_error = 5.9;
    return result;
  };
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(), exit_failed);
  EXPECT_THAT(
      testing::internal::GetCapturedStderr(),
      ContainsRegex("t: figure f: there is nothing to draw; .*/figures/t/f\\.png is of an earlier run\n"));
}

TEST_F(ResultsText, a_search_says_why_runs_failed) {
  std::ofstream(folder.path() / "t.toml")
      << "schema = 1\nname = \"t\"\ntitle = \"A test\"\nscene = \"cavity-impact\"\n[parameters]\n"
         "material = \"aluminium\"\nblock_width = \"10 um\"\nblock_height = \"11 um\"\n"
         "cavity_radius = \"1.5 um\"\nwall_thickness = [\"1 um\", \"2 um\"]\nend_time = \"16 ns\"\n"
         "[numerics]\ncell_size = \"0.4 um\"\n[search]\ncritical = \"impact_speed\"\n"
         "outcome = \"ejected\"\nbetween = [\"200 m/s\", \"1000 m/s\"]\ntolerance = \"100 m/s\"\n";
  simulate = [](const mpm::Scene& s, mpm::Observer& o) -> mpm::RunResult {
    if (s.impact_speed > 650)
      throw std::runtime_error("J < 0 in step 3, " + std::string(200, 'x') + "\nand more");
    auto result = fakes::simulate(s, o);
    result.outcome = s.impact_speed > 350 ? "ejected" : "arrested";
    return result;
  };
  for (const char* when : {"the first time", "with nothing to do"}) {
    EXPECT_EQ(run(), exit_failed) << when;
    EXPECT_THAT(table(), ContainsRegex("; failed at [0-9]+ m/s")) << when;
    EXPECT_THAT(table(),
                ContainsRegex("  failed  [0-9a-f]{12}  error: J < 0 in step 3, x+\\.\\.\\.  impact_speed = "
                              "[0-9]+ m/s, wall_thickness = [12] um\n"))
        << when;
  }
  for (const auto& line : lines())
    if (!line.starts_with("  `mpmstudy")) {
      EXPECT_LE(characters_in(line), line_columns) << line;
    }
}

TEST_F(ResultsText, coarser_cells_that_failed_are_said) {
  write("[\"1 um\", \"2 um\"]", "ladder = 3\n");
  simulate = [good = simulate](const mpm::Scene& s, mpm::Observer& o) {
    if (s.numerics.cell_size > 0.9e-6 && s.cavity_radius > 1.5e-6)
      throw std::runtime_error("J < 0 in step 3");
    return good(s, o);
  };
  EXPECT_EQ(run(), exit_failed);
  EXPECT_THAT(table(),
              ContainsRegex("  failed  [0-9a-f]{12}  error: J < 0 in step 3 .*  cavity_radius = 2 um, "
                            "cell_size = 1 um\n"));
}

TEST_F(ResultsText, a_name_has_its_unit_below_and_an_interval_too) {
  write("[\"1 um\", \"2 um\"]",
        "[[fit]]\nx = \"cavity_radius\"\ny = \"final_area_m2\"\nmodel = \"linear\"\n");
  simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    auto result = fakes::simulate(s, o);
    result.final_area = s.cavity_radius * 1e-6;
    result.final_area_error = 1e-14;
    return result;
  };
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(table(),
              ContainsRegex("cavity_radius +collapsibility +final_area +\\+- +outcome\n +um +µm² +µm²\n"));
  EXPECT_THAT(table(), ContainsRegex("  [0-9a-f]{12} +1 +[^ ]+ +1 +0.01 "));
}

TEST_F(ResultsText, values_that_round_alike_stay_apart) {
  write("\"1 um\"", "", "[\"1500.001 m/s\", \"1500.002 m/s\"]");
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(table(), ContainsRegex(" 1500\\.001 .*\n.* 1500\\.002 "));
}

TEST_F(ResultsText, failed_jobs_are_rows_with_the_first_line_of_their_reason) {
  write("[\"1 um\", \"2 um\"]", fit);
  simulate = [good = simulate](const mpm::Scene& s, mpm::Observer& o) {
    if (s.cavity_radius > 1.5e-6) throw std::runtime_error("J < 0 in step 3\nand the state of all particles");
    return good(s, o);
  };
  for (const char* when : {"the first time", "with nothing to do"}) {
    EXPECT_EQ(run(), exit_failed) << when;
    EXPECT_THAT(table(), ContainsRegex("  [0-9a-f]{12} +2 +- +- +failed\n")) << when;
    EXPECT_THAT(table(), ContainsRegex("  failed  [0-9a-f]{12}  error: J < 0 in step 3\n")) << when;
    EXPECT_THAT(output, Not(HasSubstr("the state of all particles"))) << when;
    EXPECT_THAT(table(), HasSubstr("linear of collapsibility against cavity_radius: no fit, ")) << when;
  }
}

TEST_F(ResultsText, of_many_jobs_the_first_and_the_last_and_the_query_for_all) {
  write("{ from = 1000, to = 1400, count = 41, unit = \"nm\" }");
  ASSERT_EQ(run(), 0);
  EXPECT_THAT(table(), ContainsRegex(" 1240 .*\n  \\.\\.\\. 11 more\n  [0-9a-f]{12} +1360 "));
  EXPECT_THAT(table(), Not(ContainsRegex(" 1250 ")));
  // The query is one that the catalog answers.
  const std::string begin =
      "  all: mpmstudy query --results '" + (folder.path() / "results").string() + "' \"";
  const auto at = output.find(begin);
  ASSERT_NE(at, std::string::npos) << output;
  const auto sql = output.substr(at + begin.size(), output.find("\"\n", at) - at - begin.size());
  EXPECT_EQ(query(folder.path() / "results", sql).rows.size(), 41u) << sql;
}

TEST_F(ResultsText, no_line_about_a_job_is_longer_than_120_columns) {
  write("[\"1 um\", \"2 um\"]",
        "cfl = [0.3, 0.4]\nlinear_viscosity = [0.1, 0.2]\nquadratic_viscosity = [1.0, 1.5]\n"
        "pic_fraction = [0.0, 0.01]\n[material]\nspecific_heat = [\"900 J/kg/K\", \"901 J/kg/K\"]\n"
        "initial_temperature = [\"300 K\", \"301 K\"]\nhugoniot_slope = [1.34, 1.35]\n"
        "[measure]\narea_every = [\"0.1 ns\", \"0.2 ns\"]\n");
  simulate = [](const mpm::Scene&, mpm::Observer&) -> mpm::RunResult {
    throw std::runtime_error(std::string(700, 'x'));
  };
  EXPECT_EQ(run(), exit_failed);
  for (const auto& line : lines())
    if (!line.starts_with("  all: ") && !line.starts_with("  `mpmstudy") && !line.starts_with("  ... ")) {
      EXPECT_LE(characters_in(line), line_columns) << line;
    }
  EXPECT_THAT(output, ContainsRegex("FAILED: x+\\.\\.\\.  cavity_radius = 1 um, "));
  EXPECT_THAT(table(), HasSubstr("  not shown: "));
}

TEST(DistinctTexts, get_digits_until_they_differ) {
  EXPECT_EQ(distinct_texts({1, 0.5}), (std::vector<std::string>{"1", "0.5"}));
  EXPECT_EQ(distinct_texts({1234567, 1234568}), (std::vector<std::string>{"1234567", "1234568"}));
  EXPECT_EQ(distinct_texts({2, 2}), (std::vector<std::string>{"2", "2"}));
}

TEST(TextTable, numbers_stand_right_and_texts_left) {
  EXPECT_EQ(text_table({{"a", "", {"x", "yy"}, true}, {"n", "µm", {"1", "10"}, false}}),
            "  a    n\n      µm\n  x    1\n  yy  10\n");
}

}  // namespace
}  // namespace mpmstudy
