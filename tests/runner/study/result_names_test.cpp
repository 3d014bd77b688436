// What libmpm measures, what a study may ask for, and what the catalog's page explains are the same names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "libmpm/simulation.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

std::string catalog_page() {
  std::ifstream file(SOURCE_DIR "/runner/catalog/README.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Metrics of coarse runs: a cavity, a wall that is broken, and a planar wave that reaches the free surface.
std::vector<mpm::Metric> measured() {
  std::vector<mpm::Metric> metrics;
  const std::string studies[] = {
      study_text({{"end_time", "\"1 ns\""}}, "[numerics]\ncell_size = \"0.25 um\"\n"),
      R"(schema = 1
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
cell_size = "0.3 um"
[measure]
decides = "ejection"
)",
      R"(schema = 1
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
)"};
  for (const std::string& text : studies) {
    const mpm::RunResult result = mpm::run(read_text(text).scenes.at(0));
    EXPECT_EQ(result.status, mpm::RunStatus::done) << result.reason;
    metrics.insert(metrics.end(), result.metrics.begin(), result.metrics.end());
  }
  return metrics;
}

std::string study_with_fit(const std::string& y) {
  return study_text({{"cavity_radius", "[\"1 um\", \"1.5 um\"]"}},
                    "[[fit]]\nx = \"cavity_radius\"\ny = \"" + y + "\"\nmodel = \"linear\"\n");
}

TEST(ResultNames, EveryMetricIsAcceptedAndExplained) {
  const std::string page = catalog_page();
  std::set<std::string> names;
  for (const mpm::Metric& metric : measured()) {
    names.insert(metric.name);
    EXPECT_EQ(problems_of(study_with_fit(metric.name)), "") << metric.name;
    EXPECT_THAT(page,
                testing::AnyOf(HasSubstr("| `" + metric.name + "`"), HasSubstr(", `" + metric.name + "`")))
        << "not in the table of metrics";
  }
  // Both scenes showed what they have, or nothing was tested.
  for (const char* name :
       {"momentum_error", "hot_spot_work_J_m3", "final_void_area_m2", "centroid_shift_m", "jet_impact_time_s",
        "jet_lead_m", "ejected_mass_kg_m", "ejecta_speed_m_s", "decision_margin", "new_cavities",
        "plastic_wave_speed_m_s", "free_surface_speed_m_s"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(ResultNames, WhatNothingMeasuresIsRefused) {
  const char* name = "jet_colour";
  EXPECT_THAT(problems_of(study_with_fit(name)), HasSubstr("no such result"));
  EXPECT_THAT(catalog_page(), testing::Not(HasSubstr(name)));
}

}  // namespace
}  // namespace mpmstudy
