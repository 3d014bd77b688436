#include "runner/cli/skipped_points.hpp"

#include <fmt/format.h>

#include "runner/study/characters.hpp"

namespace mpmstudy {

std::string skipped_text(const Study& study) {
  std::uint64_t points = 0;
  std::string reasons;
  for (const SkippedPoints& one : study.skipped) {
    points += one.points;
    reasons += printable_lines(fmt::format("{:>8}  {} (first: {})\n", one.points, one.why, one.first));
  }
  if (points == 0) return "";
  return fmt::format("{}: {} of {} points of the sweep are skipped, since it says invalid = \"skip\":\n{}",
                     study.name, points, points + study.scenes.size(), reasons);
}

nlohmann::ordered_json skipped_json(const Study& study) {
  auto reasons = nlohmann::ordered_json::array();
  for (const SkippedPoints& one : study.skipped)
    reasons.push_back({{"why", one.why}, {"points", one.points}, {"first", one.first}});
  return reasons;
}

}  // namespace mpmstudy
