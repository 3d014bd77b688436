// A study from file to fit and figure, by the program itself: three coarse jobs of planar impact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "runner/catalog/query.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;

constexpr const char* study = R"(
schema = 1
name   = "finish"
title  = "Stress behind the shock"
scene  = "planar-impact"
[parameters]
material     = "aluminium"
impact_speed = { values = [100, 200, 300, 400], unit = "m/s" }
block_width  = "1.6 um"
block_height = "8 um"
end_time     = "1.1 ns"
[numerics]
cell_size = "0.2 um"
[measure]
snapshots = ["1 ns"]
[[fit]]
x     = "impact_speed"
y     = "shock_normal_stress_Pa"
model = "quadratic"
[[figure]]
name  = "stress"
title = "Stress behind the shock"
kind  = "xy"
x     = "impact_speed"
y     = "shock_normal_stress_Pa"
[[figure]]
name  = "field"
title = "Pressure"
kind  = "fields"
y     = "pressure"
)";

class WholeStudy : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(file()) << study; }

  /// Exit code and what it printed.
  int mpmstudy(const std::string& arguments, std::string& printed) const {
    const std::string command =
        std::string(MPMSTUDY) + " " + arguments + " --results " + results().string() + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    while (fgets(buffer.data(), buffer.size(), pipe)) printed += buffer.data();
    return WEXITSTATUS(pclose(pipe));
  }
  fs::path file() const { return folder_.path() / "finish.toml"; }
  fs::path results() const { return folder_.path() / "results"; }

  TemporaryFolder folder_;
};

TEST_F(WholeStudy, FitsReachTheCatalogAndFiguresTheFolder) {
  std::string printed;
  ASSERT_EQ(mpmstudy("run " + file().string(), printed), 0) << printed;
  // Two waves of nearly constant speed: sigma = rho0 C u + ..., with C from 5.4 to 5.9 km/s.
  const auto rows = mpmstudy::query(results(),
                                    "SELECT coefficient, value, standard_error, r2, unit, against FROM fits "
                                    "WHERE study = 'finish' ORDER BY 1");
  ASSERT_EQ(rows.rows.size(), 3u);
  EXPECT_NEAR(std::get<double>(rows.rows[1][1]), 2700 * 5400, 0.03 * 2700 * 5400);
  EXPECT_GT(std::get<double>(rows.rows[1][3]), 0.9999);
  EXPECT_GT(std::get<double>(rows.rows[1][2]), 0);
  EXPECT_EQ(std::get<std::string>(rows.rows[1][4]), "Pa/(m/s)");
  EXPECT_EQ(std::get<std::string>(rows.rows[1][5]), "impact_speed");
  for (const char* name : {"stress.png", "stress.svg", "field-1.png", "field-4.svg", "field-1-grey.png"})
    EXPECT_TRUE(fs::exists(results() / "figures" / "finish" / name)) << name;
  EXPECT_NE(printed.find((results() / "figures" / "finish" / "stress.png").string()), std::string::npos);

  // Drawn again from the catalog, to the same bytes.
  const fs::path svg = results() / "figures" / "finish" / "stress.svg";
  const auto read = [&] {
    std::ifstream in(svg);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string before = read();
  fs::remove(svg);
  printed.clear();
  EXPECT_EQ(mpmstudy("figures " + file().string(), printed), 0) << printed;
  EXPECT_EQ(read(), before);
}

TEST_F(WholeStudy, FiguresSayWhatIsNotDone) {
  std::string printed;
  ASSERT_EQ(
      mpmstudy("run " + file().string() + " --set impact_speed='{ values = [100, 200], unit = \"m/s\" }' -q",
               printed),
      1)
      << printed;
  EXPECT_NE(printed.find("a quadratic fit needs at least 3 points; there are 2"), std::string::npos)
      << printed;
  printed.clear();
  EXPECT_EQ(mpmstudy("figures --cells 1 " + file().string(), printed), 75);
  EXPECT_NE(printed.find("2 of 4 jobs are not done"), std::string::npos) << printed;
}

// What gauges see goes from the file into the views; numbers of it into fits, intervals and figures.
TEST_F(WholeStudy, HistoriesReachTheCatalogAndAreDrawn) {
  std::ofstream(file()) << R"(
schema = 1
name   = "gauges"
scene  = "planar-impact"
[parameters]
material     = "aluminium"
impact_speed = ["200 m/s", "300 m/s"]
block_width  = "3.2 um"
block_height = "8 um"
end_time     = "1.1 ns"
[numerics]
cell_size = "0.2 um"
ladder = 3
[measure]
area_every = "0.05 ns"
[[gauge]]
name   = "middle"
of     = "pressure"
point  = ["0.4 um", "3 um"]
reduce = { plateau = "mean 0.9 ns to 1 ns" }
[[gauge]]
name = "push"
of   = "force"
wall = "bottom"
[[fit]]
x     = "impact_speed"
y     = "middle.plateau"
model = "linear"
[[figure]]
name  = "middle"
kind  = "history"
y     = "middle"
[[figure]]
name  = "plateau"
kind  = "xy"
x     = "impact_speed"
y     = "middle.plateau"
)";
  std::string printed;
  ASSERT_EQ(mpmstudy("run " + file().string(), printed), 0) << printed;
  EXPECT_NE(printed.find("middle.plateau"), std::string::npos) << printed;
  for (const char* name : {"middle.png", "plateau.svg"})
    EXPECT_TRUE(fs::exists(results() / "figures" / "gauges" / name)) << name;
  const auto rows = [&](const std::string& sql) { return mpmstudy::query(results(), sql).rows; };
  const auto samples = rows(
      "SELECT h.name, h.unit, count(*), min(h.time_s), max(h.time_s) FROM jobs j JOIN history h USING (key) "
      "WHERE j.study = 'gauges' AND j.impact_speed_m_s = 300 GROUP BY h.name ORDER BY h.name");
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(std::get<std::string>(samples[0][0]), "middle");
  EXPECT_EQ(std::get<std::string>(samples[0][1]), "Pa");
  EXPECT_EQ(std::get<std::int64_t>(samples[0][2]), 23);
  EXPECT_EQ(std::get<double>(samples[0][3]), 0);
  EXPECT_EQ(std::get<double>(samples[0][4]), 1.1e-9);
  EXPECT_EQ(std::get<std::int64_t>(samples[1][2]), 22) << "a force needs two times";
  const auto metrics = rows(
      "SELECT m.name, m.value, m.error, a.cells FROM jobs j JOIN metrics m USING (key) "
      "JOIN accuracy a ON a.key = j.key AND a.quantity = m.name WHERE j.impact_speed_m_s = 300 AND "
      "m.name = 'middle.plateau'");
  ASSERT_EQ(metrics.size(), 1u);
  EXPECT_NEAR(std::get<double>(metrics[0][1]), 2700.0 * 5750 * 300, 0.05 * 2700 * 5750 * 300);
  EXPECT_GT(std::get<double>(metrics[0][2]), 0) << "the interval of three cells";
  EXPECT_EQ(std::get<std::int64_t>(metrics[0][3]), 3);
  const auto fits = rows("SELECT unit FROM fits WHERE quantity = 'middle.plateau' ORDER BY coefficient");
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_EQ(std::get<std::string>(fits[1][0]), "Pa/(m/s)");
  printed.clear();
  EXPECT_EQ(mpmstudy("export --what history --study gauges", printed), 0);
  EXPECT_EQ(printed.find("key,name,time_s,value,unit\r\n"), 0u) << printed.substr(0, 100);
  printed.clear();
  EXPECT_EQ(mpmstudy("verify 1", printed), 0) << printed;

  // A gauge of another form makes other jobs, and it is said why.
  std::ifstream in(file());
  std::string text(std::istreambuf_iterator<char>(in), {});
  text.replace(text.find("\"3 um\""), 6, "\"4 um\"");
  std::ofstream(file()) << text;
  printed.clear();
  ASSERT_EQ(
      mpmstudy("run -q " + file().string() + " --set impact_speed='\"300 m/s\"' --set ladder=1", printed), 1)
      << printed;
  const auto newest = rows("SELECT key FROM jobs ORDER BY started_at DESC LIMIT 1");
  printed.clear();
  EXPECT_EQ(mpmstudy("explain " + std::get<std::string>(newest[0][0]), printed), 0) << printed;
  EXPECT_NE(printed.find("gauges = middle (there in another form)"), std::string::npos) << printed;
}

constexpr const char* cavity = R"(
schema = 1
name   = "cavity"
scene  = "cavity-impact"
[parameters]
material             = "aluminium"
impact_speed         = "200 m/s"
block_width          = "10 um"
block_height         = "6 um"
cavity_center_height = "3 um"
cavity_radius        = "2 um"
end_time             = "2 ns"
[numerics]
ladder = 5
[[figure]]
name  = "held"
title = "Do intervals hold?"
kind  = "calibration"
y     = "largest_collapsibility"
)";

TEST_F(WholeStudy, IntervalsReachTheCatalogAndTheCalibrationIsDrawn) {
  std::ofstream(file()) << cavity;
  std::string printed;
  ASSERT_EQ(mpmstudy("run " + file().string(), printed), 0) << printed;
  EXPECT_TRUE(fs::exists(results() / "figures" / "cavity" / "held.svg"));
  const auto rows =
      mpmstudy::query(results(),
                      "SELECT a.cells, a.error, j.collapsibility_error, a.measuring_difference, "
                      "a.scatter, a.measuring_error FROM accuracy a JOIN jobs j USING (study, key) "
                      "WHERE a.study = 'cavity' AND a.quantity = 'collapsibility'");
  ASSERT_EQ(rows.rows.size(), 1u);
  const auto number = [&](std::size_t column) { return std::get<double>(rows.rows[0][column]); };
  EXPECT_EQ(std::get<std::int64_t>(rows.rows[0][0]), 5);
  EXPECT_EQ(number(1), number(2));
  EXPECT_GT(number(3), 0);
  EXPECT_LE(std::hypot(number(3), number(4)), number(5) * (1 + 1e-9)) << "the parts, at the finest cell";
}

TEST_F(WholeStudy, AnAccuracyThatIsMissedIsNoSuccess) {
  std::ofstream(file()) << cavity;
  const std::string run = "run " + file().string() + " --set accuracy_of=largest_collapsibility --set ";
  std::string printed;
  EXPECT_EQ(mpmstudy(run + "accuracy=0.0001 --set ladder=5", printed), 1) << printed;
  EXPECT_NE(printed.find("accuracy 0.01 % of largest_collapsibility not reached by 1 of 1 jobs"),
            std::string::npos)
      << printed;
  printed.clear();
  EXPECT_EQ(mpmstudy(run + "accuracy=0.5 --set ladder=5", printed), 0) << printed;
  EXPECT_EQ(printed.find("not reached"), std::string::npos) << printed;
}

}  // namespace
