#include "runner/finish/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/extrapolation.hpp"
#include "runner/catalog/query.hpp"
#include "runner/ladder/climb.hpp"
#include "runner/study/ladder.hpp"

namespace mpmstudy {

std::vector<analysis::CalibrationPoint> calibration_of(const Study& study, const StudyResults& results,
                                                       const std::string& quantity) {
  const SqlValue parameters[] = {study.name, quantity};
  const Rows rows = query(results.folder,
                          "SELECT key, cell_size_m, value, coalesce(measuring_error, 0.0) FROM ladders WHERE "
                          "study = ?1 AND quantity = ?2 AND status = 'done' AND value IS NOT NULL",
                          parameters);
  std::map<std::string, std::vector<analysis::LadderPoint>> ladders;
  for (const auto& row : rows.rows)
    ladders[std::get<std::string>(row[0])].push_back(
        {std::get<double>(row[1]), std::get<double>(row[2]), std::abs(std::get<double>(row[3]))});
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
