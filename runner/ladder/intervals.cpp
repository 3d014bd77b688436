#include "runner/ladder/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "libmpm/measure/results.hpp"
#include "runner/catalog/accuracy.hpp"
#include "runner/ladder/climb.hpp"
#include "runner/study/requests.hpp"

namespace mpmstudy {
namespace {

/// What a ladder has of one quantity.
struct OnCells {
  std::vector<analysis::LadderPoint> points;
  std::string unit;
  bool at_finest = false;  ///< the job itself has it, not only coarser cells
};

/// quantity -> what the cells under one job have of it.
using Ladder = std::map<std::string, OnCells>;

std::map<std::string, Ladder> read_ladders(const Study& study, const std::filesystem::path& results) {
  std::map<std::string, Ladder> ladders;
  for (const LadderValue& v : ladder_values(results, study.name)) {
    if (!std::isfinite(v.cell_size) || !std::isfinite(v.value)) continue;
    const double error = std::abs(v.measuring_error.value_or(0));
    OnCells& measured = ladders[v.key][v.quantity];
    measured.points.push_back({v.cell_size, v.value, std::isfinite(error) ? error : 0});
    measured.unit = v.unit;
    measured.at_finest = measured.at_finest || v.rung_key == v.key;
  }
  return ladders;
}

/// The two parts of a measuring error, as the job itself has them. Those of a lost share are those of what it
/// is a share of, over its initial size.
void split_measuring_error(const Ladder& ladder, IntervalRow& row) {
  const auto at_finest = [&](std::string_view name) -> std::optional<double> {
    const auto found = ladder.find(std::string(name));
    if (found == ladder.end()) return std::nullopt;
    return std::ranges::min(found->second.points, {}, &analysis::LadderPoint::cell).value;
  };
  const mpm::ResultRow* measured = mpm::find_result(row.quantity);
  if (!measured) return;  // of a gauge
  double unit = 1;
  for (const std::string_view size : measured->lost_share_of) {
    const auto final_size = at_finest(size), lost = at_finest(row.quantity);
    if (size.empty() || !final_size) continue;
    // (1 - lost share) initial size = final size; one that is gone says nothing of the initial one.
    if (!lost || !(*lost < 1)) return;
    measured = mpm::find_result(size);
    unit = *final_size / (1 - *lost);
    break;
  }
  if (!(unit > 0)) return;
  const auto difference = at_finest(measured->difference), scatter = at_finest(measured->scatter);
  if (difference) row.measuring_difference = *difference / unit;
  if (scatter) row.scatter = *scatter / unit;
}

}  // namespace

std::vector<IntervalRow> intervals_of(const Study& study, const std::filesystem::path& results) {
  std::vector<IntervalRow> rows;
  for (const auto& [key, ladder] : read_ladders(study, results))
    for (const auto& [quantity, measured] : ladder) {
      if (!measured.at_finest || measured.points.size() < 2 || !has_interval(quantity)) continue;
      const auto e = analysis::extrapolate(measured.points, bounds_of(quantity));
      IntervalRow row;
      row.key = key;
      row.quantity = quantity;
      row.unit = measured.unit;
      row.value = e.value;
      row.error = e.error;
      row.extrapolated_value = e.extrapolated_value;
      row.extrapolated_error = e.extrapolated_error;
      row.observed_order = e.observed_order;
      row.method = analysis::name(e.method);
      row.cells = e.cells;
      row.discretisation_error = e.discretisation_error;
      row.measuring_error = e.measuring_error;
      split_measuring_error(ladder, row);
      if (study.ladder.accuracy && quantity == study.ladder.quantity)
        row.wanted_error = wanted_error(study.ladder, e.extrapolated_value);
      rows.push_back(std::move(row));
    }
  return rows;
}

}  // namespace mpmstudy
