#include "libmpm/scene/effect.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "libmpm/material/row.hpp"

namespace mpm {
namespace {

bool decides_ejection(const Scene& s) { return s.measures.decides == Decides::ejection; }

double zero(const Scene&) { return 0; }

constexpr Condition of_scene[] = {
    {"detached_for", "decides = \"ejection\"", decides_ejection,
     [](const Scene& s) { return default_detached_for(s); }},
    {"stop", "decides = \"ejection\"", decides_ejection, zero},
};

/// Values of `inert` are those that every job had that named none: their keys stay.
const std::vector<Condition>& table() {
  static const std::vector<Condition> all = [] {
    std::vector<Condition> conditions(std::begin(of_scene), std::end(of_scene));
    for (const MaterialRow& row : material_rows())
      if (!row.use.when.empty())
        conditions.push_back({row.name, row.use.when, row.use, row.implied.value_or(0)});
    for (const MaterialChoice& row : material_choices())
      if (!row.use.when.empty()) conditions.push_back({row.name, row.use.when, row.use, 0.0});
    return conditions;
  }();
  return all;
}

}  // namespace

std::span<const Condition> conditions() { return table(); }

const Condition* condition_of(std::string_view parameter) {
  for (const Condition& condition : table())
    if (condition.parameter == parameter) return &condition;
  return nullptr;
}

}  // namespace mpm
