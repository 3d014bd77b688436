#include "analysis/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "libmpm/core/enumerators.hpp"

namespace analysis {
namespace {

constexpr double lowest_order = 0.5, highest_order = 2.5;
constexpr std::size_t cells_of_order = 3, most_cells_of_line = 4;
constexpr double share_of_the_way = 0.5, safety_of_spread = 1.25;

using Points = std::vector<LadderPoint>;  // finest first

/// Where the straight line meets cell 0: through all of up to four points, by least squares.
double line_at_zero(const Points& points) {
  const std::size_t count = std::min(points.size(), most_cells_of_line);
  const double n = static_cast<double>(count);
  double cell = 0, value = 0, square = 0, product = 0;
  for (std::size_t i = 0; i < count; ++i) cell += points[i].cell / n, value += points[i].value / n;
  for (std::size_t i = 0; i < count; ++i) {
    square += (points[i].cell - cell) * (points[i].cell - cell);
    product += (points[i].cell - cell) * (points[i].value - value);
  }
  return value - product / square * cell;
}

/// (h3^p - h2^p) / (h2^p - h1^p), which rises with p.
double ratio_of_differences(const Points& points, double p) {
  const double fine = points[0].cell / points[1].cell, coarse = points[2].cell / points[1].cell;
  if (p == 0) return -std::log(coarse) / std::log(fine);
  return -std::expm1(p * std::log(coarse)) / std::expm1(p * std::log(fine));
}

/// The order that three values show; empty if they do not move one way, or if it is beyond all sense.
std::optional<double> order_of(const Points& points) {
  const double fine = points[0].value - points[1].value, coarse = points[1].value - points[2].value;
  if (!(fine * coarse > 0)) return std::nullopt;
  double low = -10, high = 10;
  const double wanted = coarse / fine;
  if (!(ratio_of_differences(points, low) < wanted && wanted < ratio_of_differences(points, high)))
    return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (ratio_of_differences(points, middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double spread_of(const Points& points) {
  const auto [low, high] = std::ranges::minmax(
      std::span(points).first(std::min(points.size(), cells_of_order)), {}, &LadderPoint::value);
  return high.value - low.value;
}

/// The larger distance of a value from the ends of [centre - half, centre + half] within the bounds.
double distance_to_ends(double value, double centre, double half, const Bounds& bounds) {
  const double low = std::clamp(centre - half, bounds.lower, bounds.upper);
  const double high = std::clamp(centre + half, bounds.lower, bounds.upper);
  return std::max(std::abs(value - low), std::abs(high - value));
}

Points sorted(std::span<const LadderPoint> points) {
  Points fine_first(points.begin(), points.end());
  std::ranges::sort(fine_first, {}, &LadderPoint::cell);
  const auto twice = std::ranges::adjacent_find(fine_first, {}, &LadderPoint::cell);
  if (fine_first.empty() || twice != fine_first.end() || !(fine_first[0].cell > 0))
    throw std::invalid_argument("a ladder needs cells above 0, each once");
  return fine_first;
}

}  // namespace

std::string_view name(LadderMethod method) {
  static constexpr auto names = mpm::words<LadderMethod>({{LadderMethod::observed_order, "observed order"},
                                                          {LadderMethod::first_order, "first order"},
                                                          {LadderMethod::spread, "spread"},
                                                          {LadderMethod::one_cell, "one cell"}});
  return names[static_cast<std::size_t>(method)];
}

Extrapolation extrapolate(std::span<const LadderPoint> unsorted, const Bounds& bounds,
                          double one_cell_error) {
  const Points points = sorted(unsorted);
  const auto within = [&](double value) { return std::clamp(value, bounds.lower, bounds.upper); };
  Extrapolation e;
  e.cells = static_cast<int>(points.size());
  e.value = e.extrapolated_value = points[0].value;
  for (std::size_t i = 0; i < std::min(points.size(), cells_of_order); ++i)
    e.measuring_error = std::max(e.measuring_error, points[i].measuring_error);

  double half = one_cell_error;
  if (points.size() > 1) {
    const double step = points[0].value - points[1].value;
    const bool turns = points.size() > 2 && !(step * (points[1].value - points[2].value) > 0);
    if (points.size() > 2) e.observed_order = order_of(points);
    const double line = within(line_at_zero(points));
    const bool clean =
        e.observed_order && *e.observed_order >= lowest_order && *e.observed_order <= highest_order;
    if (turns) {
      e.method = LadderMethod::spread;
      half = safety_of_spread * spread_of(points);
    } else if (clean) {
      e.method = LadderMethod::observed_order;
      const double growth = std::pow(points[1].cell / points[0].cell, *e.observed_order) - 1;
      e.extrapolated_value = within(e.value + step / growth);
      half = std::max(share_of_the_way * std::abs(e.extrapolated_value - e.value),
                      std::abs(e.extrapolated_value - line));
    } else {
      e.method = LadderMethod::first_order;
      e.extrapolated_value = line;
      half = std::max(std::abs(line - e.value), std::abs(step));
    }
  }
  const double whole = std::hypot(half, e.measuring_error);
  e.discretisation_error = distance_to_ends(e.value, e.extrapolated_value, half, bounds);
  e.error = distance_to_ends(e.value, e.extrapolated_value, whole, bounds);
  e.extrapolated_error = distance_to_ends(e.extrapolated_value, e.extrapolated_value, whole, bounds);
  return e;
}

}  // namespace analysis
