// What libmpm measures, the table of results, what a study may ask for, and what the catalog's page explains
// are the same names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "libmpm/measure/results.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/simulation.hpp"
#include "runner/study/schema.hpp"
#include "runner/study/units.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

std::string catalog_page() {
  std::ifstream file(SOURCE_DIR "/runner/catalog/VIEWS.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// One coarse run of every kind of scene, and one in which the wall is broken.
const std::map<std::string, std::string>& studies() {
  static const std::map<std::string, std::string> texts = {
      {"cavity", study_text({{"end_time", "\"1 ns\""}}, "[numerics]\ncell_size = \"0.25 um\"\n")},
      {"wall", R"(schema = 1
name = "wall"
scene = "cavity-impact"
[parameters]
material = "aluminium"
impact_speed = "900 m/s"
block_width = "10 um"
block_height = "6 um"
cavity_radius = "1.5 um"
wall_thickness = "0.5 um"
end_time = "8 ns"
[numerics]
cell_size = "0.25 um"
[measure]
decides = "ejection"
)"},
      {"sphere", R"(schema = 1
name = "sphere"
scene = "cavity-impact"
space = "axisymmetric"
[parameters]
material = "aluminium"
impact_speed = "900 m/s"
block_width = "10 um"
block_height = "6 um"
cavity_radius = "1.5 um"
wall_thickness = "0.5 um"
end_time = "2 ns"
[numerics]
cell_size = "0.25 um"
[measure]
decides = "ejection"
)"},
      {"two bodies", R"(schema = 1
name = "two-bodies"
scene = "two-body-impact"
[parameters]
material = "aluminium"
impact_speed = "1500 m/s"
block_width = "6 um"
block_height = "6 um"
cavity_radius = "1 um"
cavity_center_height = "3 um"
end_time = "1.5 ns"
[numerics]
cell_size = "0.25 um"
)"},
      {"solid", R"(schema = 1
name = "solid"
scene = "cavity-impact"
space = "three-d"
[parameters]
material = "aluminium"
impact_speed = "900 m/s"
block_width = "6 um"
block_height = "5 um"
cavity_radius = "1.5 um"
cavity_center_height = "2.2 um"
end_time = "1.5 ns"
[numerics]
cell_size = "0.5 um"
)"},
      {"planar", R"(schema = 1
name = "planar"
scene = "planar-impact"
[parameters]
material = "aluminium"
impact_speed = "200 m/s"
block_width = "1.6 um"
block_height = "8 um"
end_time = "3 ns"
[numerics]
cell_size = "0.2 um"
)"},
      {"shell", R"(schema = 1
name = "shell"
scene = "imploding-shell"
[parameters]
material = "aluminium"
inner_radius = "8 um"
outer_radius = "10 um"
inner_speed = "100 m/s"
end_time = "60 ns"
[numerics]
cell_size = "0.5 um"
)"}};
  return texts;
}

struct ValueWithError {
  mpm::Scene scene;
  mpm::RunResult result;
};

const std::map<std::string, ValueWithError>& runs() {
  static const auto all = [] {
    std::map<std::string, ValueWithError> done;
    for (const auto& [name, text] : studies()) {
      const mpm::Scene scene = read_text(text).scenes.at(0);
      done[name] = {scene, mpm::run(scene)};
      EXPECT_EQ(done[name].result.status, mpm::RunStatus::done) << done[name].result.reason;
    }
    return done;
  }();
  return all;
}

bool can_show(const mpm::ResultRow& row, const mpm::Scene& scene) {
  if (!row.belongs_to(scene.kind) || !row.spaces(scene.space)) return false;
  return row.needs == mpm::Needs::nothing || scene.measures.decides == mpm::Decides::ejection;
}

TEST(ResultsTable, HasEveryMetricOfEveryKindOfScene) {
  for (const auto& [name, run] : runs())
    for (const mpm::Metric& metric : run.result.metrics) {
      const mpm::ResultRow* row = mpm::find_result(metric.name);
      ASSERT_TRUE(row) << name << ": " << metric.name;
      EXPECT_EQ(row->unit, metric.unit) << metric.name;
      EXPECT_TRUE(can_show(*row, run.scene)) << name << ": " << metric.name;
      EXPECT_TRUE(metric.value >= row->lower && metric.value <= row->upper)
          << metric.name << " = " << metric.value;
    }
}

/// Events that did not happen in these runs are left out, and need not be in any of them.
TEST(ResultsTable, EveryRowIsShownByItsKindsOfScene) {
  std::set<std::string> seen;
  for (const auto& [name, run] : runs()) {
    std::set<std::string_view> shown;
    for (const mpm::Metric& metric : run.result.metrics) shown.insert(metric.name), seen.insert(metric.name);
    for (const mpm::ResultRow& row : mpm::results())
      if (can_show(row, run.scene) && row.metric && row.always) {
        EXPECT_TRUE(shown.contains(row.name)) << name << ": " << row.name;
      }
    const mpm::Kind& kind = mpm::kind_of(run.scene);
    EXPECT_EQ(run.result.collapsibility.has_value(),
              mpm::find_result("collapsibility")->belongs_to(run.scene.kind));
    EXPECT_EQ(run.result.area_history.empty(), !kind.has_area_history) << name;
    const bool known = std::ranges::find(kind.outcomes, run.result.outcome) != kind.outcomes.end();
    EXPECT_TRUE(known || run.result.outcome == (kind.outcomes.empty() ? "" : "undecided")) << name;
  }
  // of what is not always shown, what has to be in these runs
  for (const char* name :
       {"jet_impact_time_s", "jet_lead_m", "ejecta_speed_m_s", "decision_margin", "centroid_shift_m",
        "aspect_ratio", "lower_upper_area_ratio", "free_surface_speed_m_s", "shock_pressure_Pa",
        "plateau_noise", "plastic_wave_speed_m_s", "stop_radius_m", "stop_time_s", "roundness"})
    EXPECT_TRUE(seen.contains(name)) << name;
}

/// A kind's rows are those of the measurements that it makes, and a metric has one row only.
TEST(ResultsTable, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const mpm::ResultRow& row : mpm::results()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.meaning.empty()) << row.name;
    EXPECT_TRUE(row.metric || row.column) << row.name;
    for (const std::string_view other :
         {row.difference, row.scatter, row.lost_share_of[0], row.lost_share_of[1]})
      EXPECT_TRUE(other.empty() || mpm::find_result(other)) << row.name << ": " << other;
  }
}

std::string with_fit(const std::string& text, const std::string& y) {
  return text + "[[fit]]\nx = \"cell_size\"\ny = \"" + y + "\"\nmodel = \"linear\"\n";
}

/// Every kind of scene may ask for what it has, and is refused the rest.
TEST(ResultsTable, IsWhatStudiesMayAskFor) {
  const Units units;  // takes longer to load than a study to read
  for (const auto& [name, text] : studies()) {
    const mpm::Scene scene = runs().at(name).scene;
    std::string swept = text;
    const auto cell = swept.find("cell_size = ");
    swept.replace(cell, swept.find('\n', cell) - cell, "cell_size = [\"0.19 um\", \"0.2 um\"]");
    for (const mpm::ResultRow& row : mpm::results()) {
      const TemporaryStudy file(with_fit(swept, std::string(row.name)));
      std::string said;
      try {
        read_study(file.path(), {}, units);
      } catch (const StudyError& error) {
        said = error.what();
      }
      if (can_show(row, scene))
        EXPECT_EQ(said, "") << name << ": " << row.name;
      else
        EXPECT_NE(said, "") << name << ": " << row.name;
    }
  }
}

std::string scenes_of(const mpm::ResultRow& row) {
  std::vector<std::string_view> names;
  for (const mpm::Kind* kind : mpm::kinds())
    if (row.belongs_to(kind->kind)) names.push_back(kind->name);
  const std::string kinds = names.size() == mpm::kinds().size() ? "all" : listed(names);
  const auto& spaces = mpm::find_choice("space")->allowed;
  std::vector<std::string_view> own;
  for (std::size_t i = 0; i < spaces.size(); ++i)
    if (row.spaces(static_cast<mpm::Space>(i))) own.push_back(spaces[i]);
  return own.size() == spaces.size() ? kinds : kinds + "; " + listed(own);
}

/// The table as it has to stand on the catalog's page.
std::string metrics_table() {
  std::ostringstream text;
  text << "| name | unit | scenes | meaning |\n|---|---|---|---|\n";
  for (const mpm::ResultRow& row : mpm::results())
    if (row.metric)
      text << "| `" << row.name << "` | " << row.unit << " | " << scenes_of(row) << " | " << row.meaning
           << " |\n";
  return text.str();
}

TEST(ResultsTable, IsTheTableOfTheCatalogsPage) {
  EXPECT_NE(catalog_page().find(metrics_table()), std::string::npos)
      << "put this table into runner/catalog/VIEWS.md:\n"
      << metrics_table();
}

TEST(ResultsTable, WhatNothingMeasuresIsRefused) {
  const char* name = "jet_colour";
  EXPECT_THAT(problems_of(with_fit(studies().at("cavity"), name)), HasSubstr("no such result"));
  EXPECT_FALSE(mpm::find_result(name));
  EXPECT_THAT(catalog_page(), testing::Not(HasSubstr(name)));
}

}  // namespace
}  // namespace mpmstudy
