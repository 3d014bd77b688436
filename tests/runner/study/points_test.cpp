/// [sweep] points = "FILE.csv".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "tests/runner/study/study_text.hpp"
#include "tests/temporary_folder.hpp"

namespace mpmstudy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Points : public testing::Test {
 protected:
  Study read(const std::string& csv, const std::vector<std::pair<std::string, std::string>>& changes,
             const std::string& rest = "", const ReadOptions& options = {}) {
    std::ofstream(folder_.path() / "doe.csv", std::ios::binary) << csv;
    std::ofstream(folder_.path() / "study.toml")
        << study_text(changes, "[sweep]\npoints = \"doe.csv\"\n" + rest);
    return read_study(folder_.path() / "study.toml", options);
  }
  std::string problems(const std::string& csv,
                       const std::vector<std::pair<std::string, std::string>>& changes,
                       const std::string& rest = "", const ReadOptions& options = {}) {
    try {
      read(csv, changes, rest, options);
    } catch (const StudyError& error) {
      return error.what();
    }
    return "";
  }
  std::string place(const std::string& at) { return (folder_.path() / "doe.csv").string() + ":" + at; }

  TemporaryFolder folder_;
  const std::vector<std::pair<std::string, std::string>> without_ = {{"impact_speed", ""},
                                                                     {"cavity_radius", ""}};
};

std::vector<double> speeds(const Study& study) {
  std::vector<double> values;
  for (const mpm::Scene& scene : study.scenes) values.push_back(scene.impact_speed);
  return values;
}

TEST_F(Points, OneJobPerLine) {
  const Study study = read("impact_speed [m/s],cavity_radius [um]\n200,1\n1.5e2,2.2\n", without_);
  EXPECT_THAT(study.swept, ElementsAre("impact_speed", "cavity_radius"));
  EXPECT_THAT(speeds(study), ElementsAre(200, 150));
  EXPECT_EQ(study.scenes[1].cavity_radius, 2.2e-6);
  EXPECT_EQ(study.points_file, "doe.csv");
  EXPECT_EQ(study.units.at("cavity_radius").text, "um");
}

TEST_F(Points, AsSpreadsheetsAndPandasWriteThem) {
  const Study study = read(
      "\xEF\xBB\xBF\"impact_speed [m/s]\", cavity_radius ,material\r\n"
      "200, 1 um,\"copper\"\r\n\r\n300,\"2 um\" , tungsten \r\n",
      {{"impact_speed", ""}, {"cavity_radius", ""}, {"material", ""}});
  EXPECT_THAT(speeds(study), ElementsAre(200, 300));
  EXPECT_EQ(study.scenes[0].cavity_radius, 1e-6);
  EXPECT_THAT(study.swept, ElementsAre("impact_speed", "cavity_radius", "material"));
}

TEST_F(Points, ColumnsOfOtherTablesAndParametersOfTheStudysOwn) {
  const Study study = read("gap [um],cell_size [um],yield_stress [MPa]\n1,0.1,60\n2,0.2,80\n",
                           {{"cavity_center_height", "\"cavity_radius + gap\""}}, "[numerics]\n");
  ASSERT_EQ(study.scenes.size(), 2u);
  EXPECT_EQ(study.scenes[1].cavity_center_height, 3.5e-6);
  EXPECT_EQ(study.scenes[1].numerics.cell_size, 2e-7);
  EXPECT_EQ(study.scenes[1].material.yield_stress, 80e6);
}

TEST_F(Points, WithOtherSweepsTheyAreAGrid) {
  const Study study = read("impact_speed [m/s]\n200\n300\n",
                           {{"impact_speed", ""}, {"cavity_radius", "[\"1 um\", \"2 um\"]"}});
  EXPECT_EQ(study.scenes.size(), 4u);
}

TEST_F(Points, SetTakesThePlaceOfAColumn) {
  ReadOptions options;
  options.set = {{"impact_speed", "400 m/s"}};
  const Study study = read("impact_speed [m/s],cavity_radius [um]\n200,1\n300,2\n", without_, "", options);
  EXPECT_THAT(speeds(study), ElementsAre(400, 400));
}

TEST_F(Points, MistakesNameLineAndColumn) {
  EXPECT_EQ(problems("impact_speed [m/s],cavity_radius [um]\n200,1\n300,wide\n", without_),
            place("3:5") +
                ": cavity_radius = \"wide\": not a number; allowed: a number, in um as the first line says");
  EXPECT_THAT(problems("impact_speed [m/s],cavity_radius [um]\n200,1\n-3,1\n", without_),
              StartsWith(place("3:1") + ": impact_speed.values = -3: "));
  EXPECT_EQ(problems("impact_speed [m/s],cavity_radius [um]\n200,1\n300\n", without_),
            place("3:1") +
                ": points = \"300\": the line has 1 values; allowed: 2, as many as the first line has names");
  EXPECT_THAT(problems("impact_sped [m/s],cavity_radius [um]\n200,1\n", without_),
              HasSubstr(place("1:1") + ": impact_sped: unknown key; did you mean impact_speed?"));
  EXPECT_THAT(problems("impact_speed [kg],cavity_radius [um]\n200,1\n", without_),
              HasSubstr(place("1:1") + ": impact_speed.unit = \"kg\": 'kg' is not a unit of"));
  EXPECT_THAT(problems("impact_speed [m/s],cavity_radius [um]\n200,\n", without_),
              HasSubstr(place("2:5") + ": cavity_radius = \"\": no value; "));
  EXPECT_THAT(problems("impact_speed [m/s]\n200\n", {}),
              HasSubstr(place("1:1") + ": impact_speed: given twice, also at "));
  EXPECT_THAT(problems("impact_speed [m/s],impact_speed [m/s]\n200,300\n", {{"impact_speed", ""}}),
              HasSubstr(place("1:20") + ": impact_speed: has two columns; "));
  EXPECT_THAT(problems(",impact_speed [m/s]\n0,200\n", {{"impact_speed", ""}}),
              HasSubstr(place("1:1") + ": points = \"\": a column without a name; "));
  EXPECT_THAT(problems("impact_speed [m/s]\n", {{"impact_speed", ""}}), HasSubstr("doe.csv has no points; "));
  EXPECT_THAT(problems("impact_speed [m/s]\n\"200\n", {{"impact_speed", ""}}),
              HasSubstr(place("2:1") + ": points = \"200: a quote that is not closed; "));
  EXPECT_THAT(problems("impact_speed [m/s],cavity_radius [um]\n200,9\n", without_),
              HasSubstr(place("2:5") + ": cavity_radius = 9 um: cannot be run; "));
}

TEST_F(Points, ACavityThatDoesNotFitIsSkippedWhereThatIsSaid) {
  const Study study =
      read("impact_speed [m/s],cavity_radius [um]\n200,9\n200,1\n", without_, "invalid = \"skip\"\n");
  EXPECT_EQ(study.scenes.size(), 1u);
  ASSERT_EQ(study.skipped.size(), 1u);
  EXPECT_THAT(study.skipped[0].first, StartsWith(place("2:5")));
}

}  // namespace
}  // namespace mpmstudy
