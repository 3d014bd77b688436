#include "runner/study/searched.hpp"

#include <algorithm>

namespace mpmstudy {
namespace {

constexpr std::string_view extrapolated_suffix = "_extrapolated";

}  // namespace

Searched::Searched(const Study& study) : quantity_(mpm::find_quantity(study.search->critical)) {
  for (const mpm::Quantity& row : mpm::quantities())
    if (row.derived && row.name != quantity_->name && row.belongs_to(study.kind) &&
        std::ranges::find(study.given, row.name) != study.given.end())
      kept_.push_back(&row);
}

void Searched::set(mpm::Scene& scene, double value) const {
  std::vector<double> said;
  for (const mpm::Quantity* row : kept_) said.push_back(row->get(scene));
  quantity_->set(scene, value);
  for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i]->set(scene, said[i]);
}

std::vector<std::string> critical_names(std::string_view quantity) {
  std::vector<std::string> names;
  if (const mpm::Quantity* row = mpm::find_quantity(quantity); row && row->unit == "m/s")
    names = {"critical_speed", "critical_speed" + std::string(extrapolated_suffix)};
  const std::string own = "critical_" + std::string(quantity);
  names.insert(names.end(), {own, own + std::string(extrapolated_suffix)});
  return names;
}

std::optional<CriticalResult> critical_result(std::string_view name, std::string_view quantity) {
  if (quantity.empty()) {
    for (const mpm::Quantity& row : mpm::quantities())
      if (const auto result = critical_result(name, row.name)) return result;
    return std::nullopt;
  }
  for (const std::string& known : critical_names(quantity))
    if (name == known)
      return name.ends_with(extrapolated_suffix) ? CriticalResult::extrapolated : CriticalResult::bracket;
  return std::nullopt;
}

bool same_result(std::string_view a, std::string_view b) {
  const auto critical = critical_result(a);
  return a == b || (critical && critical == critical_result(b));
}

}  // namespace mpmstudy
