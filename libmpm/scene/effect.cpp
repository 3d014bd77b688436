#include "libmpm/scene/effect.hpp"

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "libmpm/material/rows.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {
namespace {

bool decides_ejection(const Scene& s) { return s.measures.decides == Decides::ejection; }

double zero(const Scene&) { return 0; }

constexpr Condition of_scene[] = {
    {"detached_for", "decides = \"ejection\"", decides_ejection,
     [](const Scene& s) { return default_detached_for(s); }},
    {"stop", "decides = \"ejection\"", decides_ejection, zero},
    {"wall_gap", "an impact wall", [](const Scene& s) { return kind_of(s).floor(s) == Floor::impact_wall; },
     zero},
};

/// Of row number i of `rows`, if it has one.
template <const auto& rows, std::size_t i>
void add_condition(std::vector<Condition>& conditions) {
  if (rows[i].use.when.empty()) return;
  conditions.push_back({rows[i].name, rows[i].use.when,
                        [](const Scene& s) { return rows[i].use.holds(s.material); },
                        [](const Scene&) -> double {
                          if constexpr (requires { rows[i].implied.has_value(); })
                            return rows[i].implied.value_or(0);
                          return 0;
                        }});
}
template <const auto& rows>
void add_conditions(std::vector<Condition>& conditions) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (add_condition<rows, i>(conditions), ...); }
  (std::make_index_sequence<rows.size()>());
}

/// Values of `inert` are those that every job had that named none: their keys stay.
const std::vector<Condition>& table() {
  static const std::vector<Condition> all = [] {
    std::vector<Condition> conditions(std::begin(of_scene), std::end(of_scene));
    add_conditions<material_rows>(conditions);
    add_conditions<material_choices>(conditions);
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
