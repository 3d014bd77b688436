#include "runner/finish/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/extrapolation.hpp"
#include "runner/catalog/accuracy.hpp"
#include "runner/ladder/climb.hpp"
#include "runner/study/ladder.hpp"

namespace mpmstudy {

std::vector<analysis::CalibrationPoint> calibration_of(const Study& study, const StudyResults& results,
                                                       const std::string& quantity) {
  std::map<std::string, std::vector<analysis::LadderPoint>> ladders;
  for (const LadderValue& v : ladder_values(results.folder, study.name, quantity))
    ladders[v.key].push_back({v.cell_size, v.value, std::abs(v.measuring_error.value_or(0))});
  const analysis::Bounds bounds = bounds_of(quantity);
  std::vector<analysis::CalibrationPoint> points;
  for (const JobResults& job : results.done) {
    auto& ladder = ladders[job.key];
    if (ladder.size() <= first_cells) continue;
    std::ranges::sort(ladder, std::ranges::greater{}, &analysis::LadderPoint::cell);
    const auto fine = analysis::extrapolate(ladder, bounds);
    const auto coarse = analysis::extrapolate(std::span(ladder).first(first_cells), bounds);
    const double scale = accuracy_scale(quantity, fine.extrapolated_value);
    points.push_back({coarse.error / scale, std::abs(fine.extrapolated_value - coarse.value) / scale,
                      coarse.extrapolated_error / scale,
                      std::abs(fine.extrapolated_value - coarse.extrapolated_value) / scale});
  }
  return points;
}

}  // namespace mpmstudy
