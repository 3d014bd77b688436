#include "runner/catalog/view_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "runner/catalog/sql.hpp"

namespace mpmstudy {
namespace {

/// Columns that come first in the order of rows; the others break ties, so that the same catalog gives the
/// same file.
constexpr std::string_view order_first[] = {"id",       "study",   "position", "key",
                                            "name",     "path",    "time_s",   "cell_size_m",
                                            "quantity", "against", "model",    "coefficient"};
/// Rows that these tell apart need no ties broken: sorting a long history by all columns takes its time.
constexpr std::string_view identities[] = {"id", "time_s", "path"};

std::string order_of(const View& view) {
  std::vector<std::string> order;
  const auto add = [&](std::string_view column) {
    if (std::ranges::find(order, column) == order.end()) order.emplace_back(column);
  };
  for (const auto column : order_first)
    if (view.has(column)) add(column);
  if (std::ranges::none_of(identities, [&](auto column) { return view.has(column); }))
    std::ranges::for_each(view.columns, add);
  return fmt::format("\"{}\"", fmt::join(order, "\", \""));
}

/// Views without a study are told by the keys of its jobs, or by its name; "": the view has neither.
std::string filter_of(const View& view) {
  if (view.has("study")) return " WHERE study = ?1";
  if (view.has("key")) return " WHERE key IN (SELECT key FROM jobs WHERE study = ?1)";
  return view.name == "studies" ? " WHERE name = ?1" : "";
}

}  // namespace

bool View::has(std::string_view column) const { return std::ranges::find(columns, column) != columns.end(); }

std::vector<View> views_of(const std::filesystem::path& results) {
  std::vector<View> views;
  for (const auto& row :
       ask(results, "SELECT name FROM sqlite_master WHERE type = 'view' ORDER BY name").rows) {
    const std::string name = text_of(row[0]);
    views.push_back({name, ask(results, fmt::format("SELECT * FROM \"{}\" LIMIT 0", name)).names});
  }
  return views;
}

void write_view(const std::filesystem::path& results, const View& view, const std::string& study,
                RowSink& sink) {
  const std::string filter = study.empty() ? "" : filter_of(view);
  const SqlValue name = study;
  query(results, fmt::format("SELECT * FROM \"{}\"{} ORDER BY {}", view.name, filter, order_of(view)), sink,
        filter.empty() ? std::span<const SqlValue>() : std::span(&name, 1));
}

}  // namespace mpmstudy
