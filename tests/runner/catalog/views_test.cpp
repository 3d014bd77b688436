// The names that queries, figures and other programs rely on. A failure here means that a query of a
// user may break: add columns at the end, rename none.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "libmpm/core/enumerators.hpp"
#include "libmpm/measure/results.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/schema.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

using Names = std::vector<std::string>;

class Views : public testing::Test {
 protected:
  Views() { CatalogWriter writer(folder.path()); }
  Names columns(const std::string& view) { return query(folder.path(), "SELECT * FROM " + view).names; }
  fakes::TemporaryFolder folder;
};

TEST_F(Views, jobs) {
  const auto names = columns("jobs");
  const Names start(names.begin(), names.begin() + 4);
  EXPECT_EQ(start, (Names{"key", "study", "status", "reason"}));
  EXPECT_THAT(names,
              testing::IsSupersetOf(Names{
                  "impact_speed_m_s", "wall_thickness_m", "cavity_radius_m", "yield_stress_Pa",
                  "cavity_center_height_m", "block_height_m", "block_width_m", "inner_radius_m",
                  "outer_radius_m", "inner_speed_m_s", "cell_size_m", "end_time_s", "scheme", "symmetry"}));
  const Names results = {"particles",
                         "steps",
                         "wall_s",
                         "cpu_s",
                         "energy_error",
                         "outcome",
                         "initial_area_m2",
                         "final_area_m2",
                         "final_area_error_m2",
                         "collapsibility",
                         "collapsibility_error",
                         "physics_version",
                         "git_revision",
                         "host",
                         "scene",
                         "material",
                         "position",
                         "attempt",
                         "started_at",
                         "finished_at",
                         "predicted_s",
                         "particle_updates_per_s",
                         "failure_kind",
                         "crashes",
                         "stale",
                         "flags"};
  ASSERT_GT(names.size(), results.size());
  EXPECT_EQ(Names(names.end() - static_cast<long>(results.size()), names.end()), results);
}

TEST_F(Views, jobs_has_the_columns_of_the_table_of_results) {
  const Names names = columns("jobs");
  const std::set<std::string> all(names.begin(), names.end());
  for (const mpm::ResultRow& row : mpm::results()) {
    EXPECT_EQ(row.column, all.contains(std::string(row.name))) << row.name;
    if (!row.error_column.empty()) {
      EXPECT_TRUE(row.column && all.contains(std::string(row.error_column))) << row.name;
    }
  }
}

TEST_F(Views, others) {
  EXPECT_EQ(columns("metrics"), (Names{"key", "name", "value", "unit", "error"}));
  EXPECT_EQ(columns("area_history"), (Names{"key", "time_s", "area_m2", "void_area_m2"}));
  EXPECT_EQ(columns("parameters"), (Names{"study", "key", "name", "value", "unit"}));
  EXPECT_EQ(columns("history"), (Names{"key", "name", "time_s", "value", "unit"}));
  EXPECT_EQ(columns("critical_speed"),
            (Names{"study", "wall_thickness_m", "lower_m_s", "upper_m_s", "lower_key", "upper_key",
                   "cell_size_m", "extrapolated_m_s", "interval_m_s", "flags", "runs", "position"}));
  EXPECT_EQ(columns("brackets"),
            (Names{"study", "quantity", "unit", "lower", "upper", "lower_key", "upper_key", "cell_size_m",
                   "extrapolated", "interval", "flags", "runs", "position", "swept"}));
  EXPECT_EQ(columns("claims"), (Names{"name", "sentence", "verdict", "measured", "note", "study"}));
  EXPECT_EQ(columns("fits"),
            (Names{"study", "quantity", "model", "coefficient", "value", "standard_error", "r2", "unit",
                   "against", "covariance", "reduced_chi2", "points", "family"}));
  EXPECT_EQ(columns("snapshots"), (Names{"key", "time_s", "path", "bytes", "checksum", "step"}));
  EXPECT_EQ(columns("events"),
            (Names{"key", "from_status", "to_status", "at", "by", "attempt", "reason", "id"}));
  EXPECT_EQ(columns("accuracy"),
            (Names{"study", "key", "quantity", "value", "unit", "error", "extrapolated_value",
                   "extrapolated_error", "observed_order", "method", "cells", "discretisation_error",
                   "measuring_error", "measuring_difference", "scatter", "wanted_error", "reached"}));
  EXPECT_EQ(columns("ladders"), (Names{"study", "key", "position", "rung_key", "cell_size_m", "status",
                                       "quantity", "value", "unit", "measuring_error"}));
  EXPECT_EQ(columns("studies"), (Names{"name", "title", "updated_at", "path", "overrides", "cells"}));
}

TEST_F(Views, every_column_is_documented) {
  std::ifstream file(SOURCE_DIR "/runner/catalog/VIEWS.md");
  std::stringstream text;
  text << file.rdbuf();
  for (const char* view :
       {"jobs", "metrics", "area_history", "history", "parameters", "brackets", "critical_speed", "fits",
        "snapshots", "events", "studies", "accuracy", "ladders", "claims"})
    for (const auto& column : columns(view))
      EXPECT_NE(text.str().find("`" + column + "`"), std::string::npos) << view << "." << column;
}

TEST_F(Views, what_a_scene_lacks_is_null) {
  CatalogWriter writer(folder.path());
  auto planar = fakes::job(1);
  planar.scene.kind = mpm::SceneKind::planar_impact;
  planar.scene.material.yield_stress = INFINITY;
  writer.register_study("planar", "Planar impact", {planar}, false);
  const auto rows =
      query(folder.path(),
            "SELECT impact_speed_m_s, cavity_radius_m, inner_radius_m, yield_stress_Pa, scheme, scene, "
            "material, study, particles_per_cell FROM jobs");
  ASSERT_EQ(rows.rows.size(), 1u);
  const auto& row = rows.rows[0];
  EXPECT_EQ(row[0], SqlValue(200.0));
  EXPECT_EQ(row[1], SqlValue());
  EXPECT_EQ(row[2], SqlValue());
  EXPECT_EQ(row[3], SqlValue(static_cast<double>(INFINITY)));
  EXPECT_EQ(row[4], SqlValue("gimp"));
  EXPECT_EQ(row[5], SqlValue("planar-impact"));
  EXPECT_EQ(row[6], SqlValue("aluminium"));
  EXPECT_EQ(row[7], SqlValue("planar"));
  EXPECT_EQ(row[8], SqlValue(1.0));
}

// Words and names that stand in SQL are those of the program.
TEST(Schema, ChecksAllowTheWordsOfTheirEnums) {
  std::map<std::string, std::set<std::string>> allowed;
  const std::regex check(R"(CHECK \((\w+) IN \(([^)]*)\)\))"), word("'([^']*)'");
  for (const Migration& migration : current_catalog_schema().migrations) {
    const std::string sql(migration.sql);
    for (std::sregex_iterator it(sql.begin(), sql.end(), check), end; it != end; ++it) {
      const std::string list = (*it)[2];
      for (std::sregex_iterator w(list.begin(), list.end(), word); w != end; ++w)
        allowed[(*it)[1]].insert((*w)[1]);
    }
  }
  std::map<std::string, std::set<std::string>> words;
  for (std::size_t i = 0; i < mpm::enumerators<JobStatus>(); ++i)
    words["status"].emplace(to_string(static_cast<JobStatus>(i)));
  for (std::size_t i = 0; i < mpm::enumerators<FailureKind>(); ++i)
    words["failure_kind"].emplace(to_string(static_cast<FailureKind>(i)));
  EXPECT_EQ(allowed, words);
}

TEST(Schema, ViewsNameMetricsThatThereAre) {
  const std::string sql = view_sql({});
  const std::regex named(R"(c\.name = '([^']*)')");
  int count = 0;
  for (std::sregex_iterator it(sql.begin(), sql.end(), named), end; it != end; ++it, ++count) {
    const mpm::ResultRow* row = mpm::find_result((*it)[1].str());
    EXPECT_TRUE(row && row->metric) << (*it)[1];
  }
  EXPECT_GT(count, 2);
}

}  // namespace
}  // namespace mpmstudy
