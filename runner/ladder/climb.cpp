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

/// A measuring error that one more cell leaves above this share of itself is not made small by cells.
constexpr double falls_with_the_cell = 0.9;
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
    const double wanted = wanted_error(request, e.extrapolated_value);
    if (e.extrapolated_error <= wanted) return NextStep::reached;
    const double finest = points.back().measuring_error, before = points[points.size() - 2].measuring_error;
    if (finest > wanted && finest > falls_with_the_cell * before) return NextStep::missed;
  }
  return rungs.size() < static_cast<std::size_t>(request.cells) ? NextStep::climb : NextStep::missed;
}

}  // namespace mpmstudy
