#include "runner/catalog/results_of.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <map>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/row_format.hpp"

namespace mpmstudy {
namespace {

/// Reals with the digits that give their bits back.
std::string text_of(const SQLite::Column& column) {
  switch (column.getType()) {
    case SQLITE_NULL:
      return "null";
    case SQLITE_FLOAT:
      return shortest(column.getDouble());
    default:
      return column.getString();
  }
}

/// Values of all rows; columns before `first` name a row.
void append(ResultValues& values, SQLite::Database& db, const std::string& prefix, const char* sql,
            const std::string& key, int first) {
  SQLite::Statement rows(db, sql);
  rows.bind(1, key);
  while (rows.executeStep()) {
    std::string name = prefix;
    for (int i = 0; i < first; ++i) name += (name.empty() ? "" : " ") + text_of(rows.getColumn(i));
    for (int i = first; i < rows.getColumnCount(); ++i)
      values.push_back(
          {(name.empty() ? "" : name + " ") + rows.getColumnName(i), text_of(rows.getColumn(i))});
  }
}

}  // namespace

ResultValues results_of(SQLite::Database& db, const std::string& key) {
  ResultValues values;
  append(values, db, "",
         "SELECT status, physics_version, particles, steps, energy_error, outcome, initial_area_m2, "
         "final_area_m2, final_area_error_m2, collapsibility, collapsibility_error FROM job WHERE key = ?",
         key, 0);
  append(values, db, "metrics",
         "SELECT c.name, c.value, c.unit, c.error FROM job j JOIN metric c ON c.job_id = j.id "
         "WHERE j.key = ? ORDER BY c.name",
         key, 1);
  append(values, db, "area_history",
         "SELECT c.sample, c.time_s, c.area_m2, c.void_area_m2 FROM job j JOIN area_sample c "
         "ON c.job_id = j.id WHERE j.key = ? ORDER BY c.sample",
         key, 1);
  append(values, db, "history",
         "SELECT g.name, c.sample, c.time_s, c.value, g.unit FROM job j JOIN gauge g ON g.job_id = j.id "
         "JOIN history_sample c ON c.job_id = g.job_id AND c.gauge = g.gauge WHERE j.key = ? "
         "ORDER BY g.gauge, c.sample",
         key, 2);
  append(values, db, "fields",
         "SELECT c.path, c.time_s, c.step, c.bytes, c.checksum FROM job j JOIN snapshot c ON c.job_id = j.id "
         "WHERE j.key = ? ORDER BY c.path",
         key, 1);
  return values;
}

ResultValues results_of(const std::filesystem::path& results, const std::string& key) {
  const auto db = open_for_reading(results);
  return results_of(*db, key);
}

std::string difference(const ResultValues& one, const ResultValues& other) {
  constexpr int most = 3;
  std::map<std::string, std::pair<std::string, std::string>> both;
  for (const auto& value : one) both[value.name].first = value.text;
  for (const auto& value : other) both[value.name].second = value.text;
  std::string text;
  int found = 0;
  for (const auto& [name, values] : both) {
    if (values.first == values.second || ++found > most) continue;
    const auto shown = [](const std::string& value) { return value.empty() ? "nothing" : value; };
    text += (text.empty() ? "" : ", ") + name + ": " + shown(values.first) + " and " + shown(values.second);
  }
  if (found > most) text += ", and " + std::to_string(found - most) + " more";
  return text;
}

}  // namespace mpmstudy
