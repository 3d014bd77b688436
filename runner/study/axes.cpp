#include "runner/study/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runner/study/decimal.hpp"

namespace mpmstudy {
namespace {

void refuse_cycle(const std::vector<Axis>& axes, const Axis& axis, std::vector<std::string> through,
                  Mistakes& mistakes) {
  if (!axis.expression) return;
  through.emplace_back(axis.name());
  for (const std::string& name : axis.expression->names()) {
    const auto next = std::ranges::find(axes, name, &Axis::name);
    if (next == axes.end()) continue;
    if (std::ranges::find(through, name) == through.end()) {
      refuse_cycle(axes, *next, through, mistakes);
    } else if (name == through.front()) {
      std::string cycle;
      for (const std::string& one : through) cycle += one + " -> ";
      mistakes.add(axis.value_place, axis.name(), axis.written,
                   {"is made of itself: " + cycle + name, "allowed: expressions without a cycle"});
    }
  }
}

}  // namespace

void refuse_cycles(const std::vector<Axis>& axes, Mistakes& mistakes) {
  for (const Axis& axis : axes) refuse_cycle(axes, axis, {}, mistakes);
}

void scale_cells(Axis& axis, double factor, Mistakes& mistakes) {
  const auto scaled = [&](double value) {
    const double product = round_to_12_digits(value * factor);
    if (!std::isnormal(product) && value != 0)
      mistakes.add(axis.value_place, axis.name(), axis.written,
                   {fmt::format("times --cells {} it is no cell", factor), "allowed: a factor such as 0.5"});
    return product;
  };
  if (axis.range) {
    axis.range->from = scaled(axis.range->from);
    axis.range->to = scaled(axis.range->to);
    axis.range->from_text = fmt::format("{:.12g}", axis.range->from);
    axis.range->to_text = fmt::format("{:.12g}", axis.range->to);
  }
  for (Point& point : axis.points) point.value = scaled(point.value);
}

bool may_decide_ejection(const std::vector<Axis>& axes, bool seeks_ejection) {
  for (const Axis& axis : axes)
    if (axis.name() == "decides")
      return std::ranges::any_of(axis.points, [](const Point& point) {
        return point.value == static_cast<double>(mpm::Decides::ejection);
      });
  return seeks_ejection;
}

std::vector<mpm::Space> spaces_of(const std::vector<Axis>& axes) {
  for (const Axis& axis : axes) {
    if (axis.name() != "space") continue;
    std::vector<mpm::Space> all;
    for (const Point& point : axis.points)
      all.push_back(static_cast<mpm::Space>(static_cast<int>(point.value)));
    if (!all.empty()) return all;
  }
  return {mpm::Space::plane_strain};
}

}  // namespace mpmstudy
