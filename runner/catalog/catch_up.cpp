#include "runner/catalog/catch_up.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/bind.hpp"
#include "runner/study/decimal.hpp"

namespace mpmstudy {
namespace {

/// Whether the two jobs that prove a bracket have its ends as their values of a column. A quantity that is
/// made of others is stored to rounding.
std::string ends_are(const mpm::Quantity& row) {
  const auto same = [&](const std::string& job, const std::string& end) {
    const std::string value = job + ".\"" + std::string(row.column) + "\"";
    return "abs(" + value + " - bracket." + end + ") <= 1e-9 * abs(bracket." + end + ")";
  };
  return "EXISTS (SELECT 1 FROM job l, job u WHERE l.key = bracket.lower_key AND u.key = bracket.upper_key "
         "AND " +
         same("l", "lower") + " AND " + same("u", "upper") + ")";
}

/// Up to version 6 a bracket of any quantity stood in a table of speeds.
void name_brackets(SQLite::Database& db) {
  const mpm::Quantity& speed = *mpm::find_quantity("impact_speed");
  for (const mpm::Quantity& row : mpm::quantities()) {
    if (row.name == speed.name) continue;
    SQLite::Statement name(
        db, "UPDATE bracket SET quantity = ?, unit = ? WHERE quantity = 'impact_speed' AND NOT " +
                ends_are(speed) + " AND " + ends_are(row));
    execute(name, std::string(row.name), std::string(row.unit));
  }
}

/// Up to version 6 the thickness of a wall was stored with the rounding of the lengths that it is made of.
void round_walls(SQLite::Database& db) {
  const auto function = [](sqlite3_context* context, int, sqlite3_value** lengths) {
    mpm::Scene scene;
    scene.block_height = sqlite3_value_double(lengths[0]);
    scene.cavity_center_height = sqlite3_value_double(lengths[1]);
    scene.cavity_radius = sqlite3_value_double(lengths[2]);
    sqlite3_result_double(context, mpm::find_quantity("wall_thickness")->get(scene));
  };
  db.createFunction("wall_of", 3, true, nullptr, function);
  db.exec(
      "UPDATE job SET wall_thickness_m = wall_of(block_height_m, cavity_center_height_m, cavity_radius_m) "
      "WHERE wall_thickness_m IS NOT NULL;"
      "UPDATE bracket SET wall_thickness_m = coalesce((SELECT wall_thickness_m FROM job WHERE key = "
      "lower_key), wall_thickness_m) WHERE wall_thickness_m IS NOT NULL;"
      "UPDATE bracket SET swept = json_object('wall_thickness_m', wall_thickness_m) "
      "WHERE wall_thickness_m IS NOT NULL");
}

/// Every text of a column of a table, by a function of itself.
template <class Function>
void rewrite(SQLite::Database& db, const std::string& table, const std::string& column, Function changed) {
  SQLite::Statement rows(db, "SELECT DISTINCT " + column + " FROM " + table);
  std::vector<std::string> before;
  while (rows.executeStep()) before.push_back(rows.getColumn(0).getString());
  SQLite::Statement update(db, "UPDATE " + table + " SET " + column + " = ? WHERE " + column + " = ?");
  for (const std::string& text : before)
    if (const std::string now = changed(text); now != text) execute(update, now, text);
}

/// Up to version 7 parameters stood with the last digits of what they were computed from.
void round_parameters(SQLite::Database& db) {
  std::string columns;
  for (const mpm::Quantity& row : mpm::quantities()) columns += ", \"" + std::string(row.column) + "\"";
  SQLite::Statement jobs(db, "SELECT id" + columns + " FROM job");
  struct Change {
    std::int64_t job;
    std::string set, exact;
  };
  std::vector<Change> changes;  // made once all rows are read
  while (jobs.executeStep()) {
    Change change{jobs.getColumn(0).getInt64(), "", ""};
    nlohmann::ordered_json exact;
    int i = 0;
    for (const mpm::Quantity& row : mpm::quantities()) {
      if (jobs.isColumnNull(++i)) continue;
      const double value = jobs.getColumn(i).getDouble(), written = without_rounding(value);
      if (written == value) continue;
      change.set += ", \"" + std::string(row.column) + "\" = " + shortest_text(written);
      if (!row.derived) exact[std::string(row.column)] = value;
    }
    if (change.set.empty()) continue;
    if (!exact.is_null()) change.exact = exact.dump();
    changes.push_back(std::move(change));
  }
  for (const Change& change : changes) {
    SQLite::Statement update(db, "UPDATE job SET exact = ?" + change.set + " WHERE id = ?");
    execute(update, or_null(change.exact), change.job);
  }
}

/// ... and the ends of brackets.
void round_brackets(SQLite::Database& db) {
  const auto function = [](sqlite3_context* context, int, sqlite3_value** number) {
    if (sqlite3_value_type(number[0]) == SQLITE_NULL) return sqlite3_result_null(context);
    sqlite3_result_double(context, without_rounding(sqlite3_value_double(number[0])));
  };
  db.createFunction("without_rounding", 1, true, nullptr, function);
  db.exec(
      "UPDATE bracket SET exact_lower = lower, exact_upper = upper, lower = without_rounding(lower), "
      "upper = without_rounding(upper), cell_size_m = without_rounding(cell_size_m)");
}

/// ... and numbers in JSON had the last digits of what they were computed from.
std::string with_plain_numbers(const std::string& text) {
  auto values = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!values.is_object()) return text;
  const auto before = values;
  for (auto& value : values)
    if (value.is_number_float()) value = without_rounding(value.get<double>());
  return values == before ? text : values.dump();
}

/// Up to version 7 the values in a bracket's flags had no unit: "failed at 900; flips back at 410".
void name_units_of_flags(SQLite::Database& db) {
  SQLite::Statement rows(db, "SELECT DISTINCT flags, unit FROM bracket WHERE flags LIKE '% at %'");
  std::vector<std::pair<std::string, std::string>> before;
  while (rows.executeStep())
    before.emplace_back(rows.getColumn(0).getString(), rows.getColumn(1).getString());
  SQLite::Statement update(db, "UPDATE bracket SET flags = ? WHERE flags = ? AND unit = ?");
  for (const auto& [flags, unit] : before) {
    if (unit == "1") continue;
    std::string now;
    for (std::size_t at = 0; at <= flags.size();) {
      const auto end = std::min(flags.find("; ", at), flags.size());
      const std::string one = flags.substr(at, end - at);
      now += (now.empty() ? "" : "; ") + one + (one.find(" at ") == std::string::npos ? "" : " " + unit);
      at = end + 2;
    }
    execute(update, now, flags, unit);
  }
}

}  // namespace

void catch_up(SQLite::Database& db, std::int32_t version) {
  if (version == 0) return;  // a new one
  if (version < 7) {
    name_brackets(db);
    round_walls(db);
  }
  if (version < 8) {
    round_parameters(db);
    round_brackets(db);
    rewrite(db, "bracket", "swept", with_plain_numbers);
    rewrite(db, "fit", "family", with_plain_numbers);
    name_units_of_flags(db);
  }
}

}  // namespace mpmstudy
