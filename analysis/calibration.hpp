#pragma once
/// Do intervals hold?
#include <span>
#include <utility>
#include <vector>

namespace analysis {

/// What coarse cells said of one number, against what fine cells came to. Relative.
struct CalibrationPoint {
  double error = 0;                    ///< half width about the value at the finest of the coarse cells
  double difference = 0;               ///< of that value from the fine one
  double extrapolated_error = 0;       ///< half width about the extrapolated value
  double extrapolated_difference = 0;  ///< of that from the fine one
};

struct Calibration {
  int points = 0;
  double covered = 0;            ///< share of the points whose difference is not above the half width
  double median_half_width = 0;  ///< of all points
};

/// Of pairs (half width, difference); at least one.
Calibration calibrate(std::span<const std::pair<double, double>>);
/// The two intervals of calibration points.
std::vector<std::pair<double, double>> about_the_value(std::span<const CalibrationPoint>);
std::vector<std::pair<double, double>> about_the_extrapolated_value(std::span<const CalibrationPoint>);

}  // namespace analysis
