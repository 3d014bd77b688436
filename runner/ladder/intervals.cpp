#include "runner/ladder/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <map>

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

/// The two parts of the measuring error of the final area, as the job itself has them.
void split_measuring_error(const Ladder& ladder, IntervalRow& row) {
  const bool share = row.quantity == "collapsibility";
  if (!share && row.quantity != "final_area_m2") return;
  const auto at_finest = [&](const char* name) -> std::optional<double> {
    const auto found = ladder.find(name);
    if (found == ladder.end()) return std::nullopt;
    return std::ranges::min(found->second.points, {}, &analysis::LadderPoint::cell).value;
  };
  // In axisymmetry a collapsibility is made of volumes.
  const bool volumes = share && ladder.contains("final_volume_m3");
  const auto final_size = at_finest(volumes ? "final_volume_m3" : "final_area_m2");
  const auto collapsed = at_finest("collapsibility");
  // (1 - collapsibility) initial size = final size; one that is gone says nothing of the initial one.
  const double unit =
      share ? (final_size && collapsed && *collapsed < 1 ? *final_size / (1 - *collapsed) : 0) : 1;
  if (!(unit > 0)) return;
  const auto difference = at_finest(volumes ? "final_volume_difference_m3" : "final_area_difference_m2");
  const auto scatter = at_finest(volumes ? "final_volume_scatter_m3" : "final_area_scatter_m2");
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
