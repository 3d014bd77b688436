#include "runner/ladder/climb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "libmpm/measure/results.hpp"
#include "runner/study/ladder.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {

namespace {
/// If a finer cell leaves more than this share of a measuring error, still finer cells will not make it
/// small.
constexpr double falls_with_the_cell = 0.9;
}  // namespace

analysis::Bounds bounds_of(const std::string& quantity) {
  const mpm::ResultRow* row = mpm::find_result(quantity);
  return row ? analysis::Bounds{row->lower, row->upper} : analysis::Bounds{};
}

double accuracy_scale(const std::string& quantity, double value) {
  const mpm::ResultRow* row = mpm::find_result(quantity);
  return std::max(std::abs(value), row ? row->least_scale : 0.0);
}

double wanted_error(const LadderRequest& request, double value) {
  return *request.accuracy * accuracy_scale(request.quantity, value);
}

Climb next_step(const LadderRequest& request, std::span<const RungState> rungs) {
  if (!std::ranges::all_of(rungs, &RungState::decided)) return {NextStep::wait, {}};
  if (!rungs.back().point) return {NextStep::missed, {}};
  std::vector<analysis::LadderPoint> points;
  for (const RungState& rung : rungs)
    if (rung.point) points.push_back(*rung.point);
  std::string reason = fmt::format("a finer cell: {} of {} coarser ones show {}", points.size(), rungs.size(),
                                   request.quantity);
  if (points.size() >= first_cells) {
    const analysis::Extrapolation e = analysis::extrapolate(points, bounds_of(request.quantity));
    const double wanted = wanted_error(request, e.extrapolated_value);
    if (e.extrapolated_error <= wanted) return {NextStep::reached, {}};
    const double finest = points.back().measuring_error, before = points[points.size() - 2].measuring_error;
    if (finest > wanted && finest > falls_with_the_cell * before) return {NextStep::missed, {}};
    const mpm::ResultRow* row = mpm::find_result(request.quantity);
    const std::string_view unit = row ? row->unit : request.unit;
    reason =
        fmt::format("a finer cell: {} is known to +- {} from {} cells, wanted is +- {}", request.quantity,
                    readable(e.extrapolated_error, unit), points.size(), readable(wanted, unit));
  }
  if (rungs.size() >= static_cast<std::size_t>(request.cells)) return {NextStep::missed, {}};
  return {NextStep::climb, std::move(reason)};
}

}  // namespace mpmstudy
