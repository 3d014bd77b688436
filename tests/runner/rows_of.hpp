#pragma once
/// A whole catalog as text: every bit of every result, and nothing that depends on when, where and how often.
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "runner/catalog/query.hpp"
#include "runner/catalog/row_format.hpp"

namespace mpmstudy {

/// One line per value: "collapsibility=0.25".
inline std::string rows_of(const std::filesystem::path& results) {
  static const std::set<std::string> left_out = {
      "wall_s",  "cpu_s",   "started_at", "finished_at", "predicted_s", "particle_updates_per_s",
      "attempt", "crashes", "host",       "git_revision"};
  std::string text;
  for (const char* rows :
       {"jobs ORDER BY study, key", "metrics ORDER BY key, name", "area_history ORDER BY key, time_s",
        "history ORDER BY key, name, time_s", "snapshots ORDER BY key, path",
        "fits ORDER BY study, quantity, against, model, coefficient"}) {
    const auto table = query(results, std::string("SELECT * FROM ") + rows);
    for (const auto& row : table.rows)
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (left_out.contains(table.names[i])) continue;
        std::ostringstream value;
        make_row_sink(RowFormat::csv, value)->row(std::span(&row[i], 1));
        text += table.names[i] + "=" + value.str();
      }
  }
  return text;
}

}  // namespace mpmstudy
