#include "runner/study/wanted_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "runner/study/written_unit.hpp"

namespace mpmstudy {

bool WantedPoints::wants(Mistakes& mistakes) {
  for (const Requirement& one : request_.requirements) {
    const double holds = one.expression.value(std::cref(value_));
    if (holds == 1) continue;
    constexpr std::size_t most = 20;  // more would tell nothing new
    if (holds != 0 && mistakes.size() < most)
      mistakes.add(
          one.place, "require", one.written,
          {fmt::format("is {:.6g} for {}", holds, values_of(one)), "allowed: what is true (1) or false (0)"});
    else if (holds == 0)
      skip("require = " + one.written + " does not hold", values_of(one), &one);
    return false;
  }
  return true;
}

void WantedPoints::skip(const std::string& why, const std::string& first, const Requirement* of) {
  auto known = std::ranges::find(skipped_, why, &SkippedPoints::why);
  if (known == skipped_.end()) {
    known = skipped_.insert(skipped_.end(), {why, first, 0});
    requirements_.push_back(of);
  }
  ++known->points;
}

std::vector<SkippedPoints> WantedPoints::end(bool nothing_left, std::uint64_t points, Mistakes& mistakes) {
  for (std::size_t k = 0; k < skipped_.size() && !request_.skips_invalid; ++k)
    mistakes.add(requirements_[k]->place, "require", requirements_[k]->written,
                 {fmt::format("does not hold in {} of {} points, first for {}", skipped_[k].points, points,
                              skipped_[k].first),
                  "allowed: points for which it holds, or invalid = \"skip\" to leave such points out"});
  if (request_.skips_invalid && nothing_left && mistakes.empty()) {
    std::string why;
    for (const SkippedPoints& one : skipped_)
      why += fmt::format("{}{} of {} points: {} ({})", why.empty() ? "" : ", ", one.points, points, one.why,
                         one.first);
    mistakes.add(request_.invalid_place, "invalid", "\"skip\"",
                 {"no point of the sweep is left", "the reasons: " + why});
  }
  return std::move(skipped_);
}

/// "cavity_radius = 1 um, wall = 0.2 um".
std::string WantedPoints::values_of(const Requirement& one) const {
  std::string text;
  for (const std::string& name : one.expression.names()) {
    const auto axis = std::ranges::find(request_.axes, name, &Axis::name);
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name,
                        in_written_unit(value_(name), axis->quantity->unit, name, request_.units));
  }
  return text;
}

}  // namespace mpmstudy
