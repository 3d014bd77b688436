#include "runner/catalog/catch_up.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/bind.hpp"

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

}  // namespace

void catch_up(SQLite::Database& db, std::int32_t version) {
  if (version == 0) return;  // a new one
  if (version >= 7) return;
  name_brackets(db);
  round_walls(db);
}

}  // namespace mpmstudy
