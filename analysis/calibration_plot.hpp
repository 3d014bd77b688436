#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/calibration.hpp"

namespace analysis {

/// Actual difference against predicted half width, both as shares of the value on logarithmic axes: points
/// below the diagonal are intervals that hold. Both kinds of interval; how often they hold and their median
/// half width stand under the title.
struct CalibrationPlot {
  std::string title;
  std::string footer;
  std::vector<CalibrationPoint> points;
};

/// "64 jobs: value 98 % held, median ± 2.6 %; extrapolated 93 % held, median ± 1.5 %"
std::string calibration_caption(const std::vector<CalibrationPoint>&);

/// Writes stem.png and stem.svg. Differences below the axis are drawn on its edge. Throws
/// std::invalid_argument without points, std::runtime_error where gnuplot or the disk fails.
void draw(const CalibrationPlot&, const std::filesystem::path& stem);

}  // namespace analysis
