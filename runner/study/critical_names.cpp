#include "runner/study/critical_names.hpp"

#include "libmpm/scene/parameters.hpp"

namespace mpmstudy {
namespace {

constexpr std::string_view suffix = "_extrapolated";

}  // namespace

std::vector<std::string> critical_names(std::string_view quantity) {
  std::vector<std::string> names;
  if (const mpm::Quantity* row = mpm::find_quantity(quantity); row && row->unit == "m/s")
    names = {"critical_speed", "critical_speed" + std::string(suffix)};
  const std::string own = "critical_" + std::string(quantity);
  names.insert(names.end(), {own, own + std::string(suffix)});
  return names;
}

std::optional<CriticalResult> critical_result(std::string_view name, std::string_view quantity) {
  if (quantity.empty()) {
    for (const mpm::Quantity& row : mpm::quantities())
      if (const auto result = critical_result(name, row.name)) return result;
    return std::nullopt;
  }
  for (const std::string& known : critical_names(quantity))
    if (name == known) return name.ends_with(suffix) ? CriticalResult::extrapolated : CriticalResult::bracket;
  return std::nullopt;
}

bool same_result(std::string_view a, std::string_view b) {
  const auto critical = critical_result(a);
  return a == b || (critical && critical == critical_result(b));
}

}  // namespace mpmstudy
