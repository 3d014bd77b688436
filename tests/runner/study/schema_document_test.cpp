/// The pages of studies/ are up to date: their table of parameters is the one of libmpm, and they name every
/// key.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "libmpm/io/fields.hpp"
#include "libmpm/scene/gauge.hpp"
#include "runner/study/figure_kinds.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

std::string page(const std::string& name) {
  std::ifstream stream(SOURCE_DIR "/studies/" + name);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

template <class Row>
std::string scenes_of(const Row& row) {
  std::vector<std::string_view> kinds;
  for (const auto name : mpm::scene_kind_names())
    if (row.belongs_to(*mpm::scene_kind_from(name))) kinds.push_back(name);
  return kinds.size() == mpm::scene_kind_names().size() ? "all" : listed(kinds);
}

std::string_view range_of(mpm::Range range) {
  switch (range) {
    case mpm::Range::positive:
      return "> 0";
    case mpm::Range::non_negative:
      return ">= 0";
    case mpm::Range::non_negative_or_infinite:
      return ">= 0, or infinite";
    case mpm::Range::count:
      return "1, 2, ...";
    case mpm::Range::any:
      return "any";
  }
  return "";
}

std::string need_of(const mpm::Quantity& row) {
  if (!row.required) return "";
  return row.alternative.empty() ? "yes" : "yes, or `" + std::string(row.alternative) + "`";
}

/// The table as it has to stand in studies/PARAMETERS.md.
std::string parameter_table() {
  std::ostringstream text;
  text
      << "| table | key | SI unit | allowed | required | scenes | meaning |\n|---|---|---|---|---|---|---|\n";
  for (const mpm::Quantity& row : mpm::quantities())
    text << "| `[" << table_name(row.section) << "]` | `" << row.name << "` | " << row.unit << " | "
         << range_of(row.range) << " | " << need_of(row) << " | " << scenes_of(row) << " | " << row.meaning
         << " |\n";
  for (const mpm::Choice& row : mpm::choices())
    text << "| `[" << table_name(row.section) << "]` | `" << row.name << "` | a word | "
         << listed(row.allowed) << " |  | " << scenes_of(row) << " | " << row.meaning << " |\n";
  return text.str();
}

TEST(StudiesReadme, ParameterTableIsTrue) {
  EXPECT_NE(page("PARAMETERS.md").find(parameter_table()), std::string::npos)
      << "put this table into studies/PARAMETERS.md:\n"
      << parameter_table();
}

/// The list of fields as it has to stand in studies/README.md, but for the ends of lines.
TEST(StudiesReadme, FieldsAreThoseOfSnapshots) {
  std::string fields = "Fields:";
  for (const mpm::Field& field : mpm::fields())
    fields += (fields.ends_with(":") ? " `" : ", `") + std::string(field.name) + "`";
  fields += ".";
  std::string text = page("README.md");
  std::ranges::replace(text, '\n', ' ');
  EXPECT_NE(text.find(fields), std::string::npos) << "put this into studies/README.md:\n" << fields;
}

/// The table as it has to stand in studies/GAUGES.md.
std::string gauge_table() {
  using mpm::GaugeTarget;
  std::string text = "| a gauge at | `of` | unit | meaning |\n|---|---|---|---|\n";
  for (const auto& [target, words] :
       {std::pair{GaugeTarget::place, "a point, a place, a beam"}, std::pair{GaugeTarget::body, "a body"},
        std::pair{GaugeTarget::wall, "a wall"}})
    // what a place has, points and beams have, too; position is theirs alone
    for (const mpm::GaugeQuantity& one :
         mpm::gauge_quantities(target == GaugeTarget::place ? GaugeTarget::point : target)) {
      const bool shared = mpm::find_gauge_quantity(target, one.name);
      text += "| " + std::string(shared ? words : "a point, a beam") + " | `" + std::string(one.name) +
              "` | " + std::string(one.unit);
      if (one.axisymmetric != one.unit)
        text += " (" + std::string(one.axisymmetric) + ", " + std::string(one.three_d) + ")";
      text += " | " + std::string(one.meaning) + " |\n";
    }
  return text;
}

TEST(StudiesReadme, GaugeTableIsTrue) {
  EXPECT_NE(page("GAUGES.md").find(gauge_table()), std::string::npos)
      << "put this table into studies/GAUGES.md:\n"
      << gauge_table();
}

TEST(StudiesReadme, NamesEveryKindOfFigure) {
  for (const FigureKindRow& row : figure_kinds)
    EXPECT_NE(page("README.md").find("| `\"" + std::string(row.word) + "\"` |"), std::string::npos)
        << row.word;
}

TEST(StudiesReadme, NamesEveryKeyAndTable) {
  const std::string text = page("README.md") + page("PARAMETERS.md") + page("SWEEPS.md") + page("GAUGES.md");
  for (const std::string_view table : table_names()) {
    for (const std::string_view key : keys_of(table))
      EXPECT_NE(text.find("`" + std::string(key) + "`"), std::string::npos) << table << " " << key;
    if (table.empty()) continue;
    EXPECT_NE(text.find("[" + std::string(table) + "]"), std::string::npos) << table;
  }
}

}  // namespace
}  // namespace mpmstudy
