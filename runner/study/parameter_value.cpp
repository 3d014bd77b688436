#include "runner/study/parameter_value.hpp"

#include <algorithm>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

const mpm::Label* label_in(const mpm::Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.labels, name, &mpm::Label::name);
  return found == scene.labels.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> quantity_value(const mpm::Scene& scene, std::string_view name) {
  if (const mpm::Label* label = label_in(scene, name)) return label->value;
  if (const mpm::Quantity* row = mpm::find_quantity(name)) return row->get(scene);
  return std::nullopt;
}

std::string quantity_unit(const Study& study, std::string_view name) {
  const auto own = std::ranges::find(study.own, name, &OwnParameter::name);
  if (own != study.own.end()) return own->unit;
  const mpm::Quantity* row = mpm::find_quantity(name);
  return row ? std::string(row->unit) : "";
}

double parameter_number(const mpm::Scene& scene, std::string_view name) {
  if (const auto value = quantity_value(scene, name)) return *value;
  const mpm::Choice* row = mpm::find_choice(name);
  return row ? static_cast<double>(row->get(scene)) : 0;
}

std::string readable_parameter(const mpm::Scene& scene, std::string_view name) {
  if (const mpm::Label* label = label_in(scene, name))
    return label->written.empty() ? readable(label->value, label->unit) : label->written;
  if (const mpm::Quantity* row = mpm::find_quantity(name)) return readable(*row, scene);
  if (const mpm::Choice* row = mpm::find_choice(name)) return readable(*row, scene);
  return "";
}

}  // namespace mpmstudy
