#include "runner/ladder/climb.hpp"

#include <algorithm>
#include <cmath>

#include "runner/study/ladder.hpp"

namespace mpmstudy {

namespace {
/// Of the initial area; may be close to nothing.
bool is_collapse(const std::string& quantity) {
  return quantity == "collapsibility" || quantity == "largest_collapsibility";
}
}  // namespace

analysis::Bounds bounds_of(const std::string& quantity) {
  if (is_collapse(quantity)) return {.upper = 1};  // a torn cavity may be larger than it was
  if (quantity.ends_with("_area_m2") || quantity.ends_with("_fraction") || quantity == "roundness")
    return {.lower = 0};
  return {};
}

double accuracy_scale(const std::string& quantity, double value) {
  return std::max(std::abs(value), is_collapse(quantity) ? 0.1 : 0.0);
}

double wanted_error(const LadderRequest& request, double value) {
  return *request.accuracy * accuracy_scale(request.quantity, value);
}

NextStep next_step(const LadderRequest& request, std::span<const RungState> rungs) {
  if (!std::ranges::all_of(rungs, &RungState::decided)) return NextStep::wait;
  if (!rungs.back().point) return NextStep::missed;
  std::vector<analysis::LadderPoint> points;
  for (const RungState& rung : rungs)
    if (rung.point) points.push_back(*rung.point);
  if (points.size() >= first_cells) {
    const analysis::Extrapolation e = analysis::extrapolate(points, bounds_of(request.quantity));
    if (e.extrapolated_error <= wanted_error(request, e.extrapolated_value)) return NextStep::reached;
  }
  return rungs.size() < static_cast<std::size_t>(request.cells) ? NextStep::climb : NextStep::missed;
}

}  // namespace mpmstudy
