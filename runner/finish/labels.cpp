#include "runner/finish/labels.hpp"

#include <algorithm>

#include "libmpm/io/fields.hpp"
#include "libmpm/measure/results.hpp"
#include "libmpm/scene/gauge.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/physics_version.hpp"
#include "runner/study/parameter_value.hpp"

namespace mpmstudy {

analysis::QuantityLabel label_of(std::string_view name, std::string_view unit_if_unknown) {
  const auto of_row = [](const auto& row) {
    return analysis::quantity_label(row.name, row.unit, row.symbol, row.title);
  };
  if (const mpm::Quantity* row = mpm::find_quantity(name)) return of_row(*row);
  if (const mpm::ResultRow* row = mpm::find_result(name)) return of_row(*row);
  if (const mpm::Field* row = mpm::find_field(name)) return of_row(*row);
  if (mpm::is_of_gauge(name)) return {std::string(name), "", std::string(unit_if_unknown)};
  if (name == "time") return {"Time", "t", "s"};
  if (name == "area") return {"Cavity area", "A", "m^2"};
  return analysis::quantity_label(name, unit_if_unknown);
}

analysis::QuantityLabel label_of_parameter(const Study& study, const std::string& name) {
  const auto own = std::ranges::find(study.own, name, &OwnParameter::name);
  if (own != study.own.end()) return {name, "", own->unit};
  return label_of(name, quantity_unit(study, name));
}

std::set<int> physics_versions_of(const Study& study) {
  std::set<int> versions;
  for (const mpm::Scene& scene : study.scenes) versions.insert(mpm::physics_version_of(scene));
  return versions;
}

std::string physics_versions_text(const std::set<int>& versions) {
  std::string text = versions.size() > 1 ? "physics versions " : "physics version ";
  for (const int version : versions)
    text += (version == *versions.begin() ? "" : " and ") + std::to_string(version);
  return text;
}

}  // namespace mpmstudy
