#include "analysis/calibration.hpp"

#include <algorithm>
#include <stdexcept>

namespace analysis {

Calibration calibrate(std::span<const std::pair<double, double>> pairs) {
  if (pairs.empty()) throw std::invalid_argument("a calibration needs points");
  std::vector<double> half_widths;
  double covered = 0;
  for (const auto& [half_width, difference] : pairs) {
    half_widths.push_back(half_width);
    covered += difference <= half_width;
  }
  std::ranges::sort(half_widths);
  const std::size_t n = half_widths.size();
  const double median = n % 2 == 1 ? half_widths[n / 2] : 0.5 * (half_widths[n / 2 - 1] + half_widths[n / 2]);
  return {static_cast<int>(n), covered / static_cast<double>(n), median};
}

std::vector<std::pair<double, double>> about_the_value(std::span<const CalibrationPoint> points) {
  std::vector<std::pair<double, double>> pairs;
  for (const auto& p : points) pairs.emplace_back(p.error, p.difference);
  return pairs;
}

std::vector<std::pair<double, double>> about_the_extrapolated_value(
    std::span<const CalibrationPoint> points) {
  std::vector<std::pair<double, double>> pairs;
  for (const auto& p : points) pairs.emplace_back(p.extrapolated_error, p.extrapolated_difference);
  return pairs;
}

}  // namespace analysis
