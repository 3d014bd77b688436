#include "runner/search/bracket_rows.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "runner/search/critical_value.hpp"
#include "runner/study/decimal.hpp"
#include "runner/study/parameter_value.hpp"

namespace mpmstudy {
namespace {

/// JSON object: column of the view `jobs` -> value, of what the study sweeps beside its cells.
std::string swept_values(const Study& study, const mpm::Scene& scene) {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const std::string& name : study.swept) {
    if (name == "cell_size") continue;  // has a column of its own
    const mpm::Quantity* q = mpm::find_quantity(name);
    if (const auto value = quantity_value(scene, name))
      values[q ? std::string(q->column) : name] = without_rounding(*value);
    else if (const mpm::Choice* c = mpm::find_choice(name))
      values[std::string(c->column)] = c->allowed[c->get(scene)];
  }
  return values.dump();
}

}  // namespace

std::vector<BracketRow> bracket_rows(const Study& study, const std::vector<FoundBracket>& brackets) {
  std::map<std::pair<std::size_t, double>, std::vector<CellBracket>> ladders;  // coarse cells come first
  for (const FoundBracket& b : brackets)
    if (b.lower) ladders[{b.point.family, b.point.along}].push_back({b.point.cell, *b.lower, *b.upper});
  const mpm::Quantity* critical = mpm::find_quantity(study.search->critical);
  const mpm::Quantity* wall = mpm::find_quantity("wall_thickness");
  std::vector<BracketRow> rows;
  for (const FoundBracket& b : brackets) {
    BracketRow row;
    row.quantity = critical->name;
    row.unit = critical->unit;
    row.lower = b.lower;
    row.upper = b.upper;
    row.lower_key = b.lower_key;
    row.upper_key = b.upper_key;
    row.cell_size = b.point.cell;
    row.flags = b.flags;
    row.runs = b.runs;
    row.position = static_cast<std::int64_t>(b.point.position);
    row.swept = swept_values(study, b.point.scene);
    if (wall != critical && wall->belongs_to(study.kind)) row.wall_thickness = wall->get(b.point.scene);
    const auto& ladder = ladders[{b.point.family, b.point.along}];
    if (b.lower && ladder.back().cell == b.point.cell)
      if (const auto extrapolated = critical_value_at_cell_0(ladder)) {
        row.extrapolated = extrapolated->value;
        row.interval = extrapolated->interval;
      }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace mpmstudy
