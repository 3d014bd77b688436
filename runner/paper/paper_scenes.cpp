#include "runner/paper/paper_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

/// What a quantity is in a study that claims of the paper rest on; the same as in studies/.
struct Condition {
  std::string_view study;
  std::string_view quantity;
  std::vector<double> values;  ///< SI; all of them, and no other
};

const std::vector<Condition>& conditions() {
  static const std::vector<Condition> all = {
      {"planar-impact", "impact_speed", {20, 200, 1120, 1500}},
      {"two-body-jet", "impact_speed", {1500}},
      {"two-body-jet", "cavity_radius", {1.5e-6}},
      {"two-body-jet", "cavity_center_height", {10e-6}},
      {"two-body-jet", "block_height", {15e-6}},
      {"strong-collapse", "impact_speed", {1120}},
      {"strong-collapse", "cavity_radius", {1.5e-6}},
      {"strong-collapse", "wall_thickness", {3e-6}},
      {"strong-collapse", "block_height", {11e-6}},
      {"critical-speed", "cavity_radius", {1.5e-6}},
      {"critical-speed", "block_height", {11e-6}},
      {"critical-speed", "wall_thickness", {0.5e-6, 1e-6, 1.5e-6, 2e-6, 2.5e-6, 3e-6, 3.5e-6, 4e-6}},
      {"critical-speed-spall", "cavity_radius", {1.5e-6}},
      {"critical-speed-spall", "block_height", {11e-6}},
      {"critical-speed-spall", "wall_thickness", {0.5e-6, 1e-6, 2e-6, 3e-6, 3.5e-6}},
      {"critical-speed-spall", "spall_strength", {1e9, 3e9}},
      {"weak-collapse", "impact_speed", {200}},
      {"weak-collapse", "cavity_radius", {1.5e-6}},
      {"weak-collapse", "cavity_center_height", {1.9e-6}},
      {"weak-collapse", "block_height", {5e-6}},
      {"symmetry", "impact_speed", {200}},
      {"symmetry", "cavity_radius", {1.5e-6}},
      {"symmetry", "cavity_center_height", {1.5e-6, 1.9e-6, 2.3e-6, 2.7e-6, 3.5e-6, 5e-6}},
      {"symmetry", "block_height", {4.6e-6, 5e-6, 5.4e-6, 5.8e-6, 6.6e-6, 8.1e-6}},
      {"collapsibility-radius", "impact_speed", {200}},
      {"collapsibility-radius", "cavity_radius", {1e-6, 1.5e-6, 2e-6, 2.5e-6}},
      {"collapsibility-radius", "cavity_center_height", {3e-6}},
      {"collapsibility-radius", "block_height", {6e-6}},
      {"collapsibility-yield", "impact_speed", {200}},
      {"collapsibility-yield", "cavity_radius", {1.5e-6}},
      {"collapsibility-yield", "cavity_center_height", {1.9e-6}},
      {"collapsibility-yield", "block_height", {5e-6}},
      {"collapsibility-yield", "yield_stress", {60e6, 90e6, 120e6, 160e6, 200e6, 260e6, 330e6, 400e6}},
      {"scale-invariance", "impact_speed", {200}},
      {"scale-invariance", "cavity_radius", {1.5e-6, 6e-6}},
      {"scale-invariance", "cavity_center_height", {1.9e-6, 7.6e-6}},
      {"scale-invariance", "block_height", {5e-6, 20e-6}},
  };
  return all;
}

/// Infinite constants are the same, too: their difference is no number.
bool same(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// The values that the study should have; of a material constant that of the paper's aluminium.
std::vector<double> values_of(const Study& study, const mpm::Quantity& q) {
  for (const Condition& c : conditions())
    if (c.study == study.name && c.quantity == q.name) return c.values;
  const bool constant = q.section == mpm::Section::material || q.name == "yield_stress";
  if (!constant) return {};
  mpm::Scene aluminium = study.scenes.front();
  aluminium.material = mpm::named_material("aluminium");
  return {q.get(aluminium)};
}

std::string text_of(const mpm::Quantity& q, const Study& study, const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    mpm::Scene scene = study.scenes.front();
    q.set(scene, value);
    text += (text.empty() ? "" : ", ") + readable(q, scene);
  }
  return text;
}

}  // namespace

std::string unlike_the_paper(const Study& study) {
  const bool known =
      std::ranges::any_of(conditions(), [&](const Condition& c) { return c.study == study.name; });
  if (!known || study.scenes.empty()) return "";
  std::string text;
  for (const mpm::Quantity& q : mpm::quantities()) {
    if (!q.belongs_to(study.kind) || (study.search && study.search->critical == q.name)) continue;
    const std::vector<double> wanted = values_of(study, q);
    if (wanted.empty()) continue;
    std::vector<double> said;
    for (const mpm::Scene& scene : study.scenes)
      if (std::ranges::none_of(said, [&](double v) { return same(v, q.get(scene)); }))
        said.push_back(q.get(scene));
    const bool equal = said.size() == wanted.size() && std::ranges::all_of(said, [&](double v) {
                         return std::ranges::any_of(wanted, [&](double w) { return same(v, w); });
                       });
    if (!equal)
      text += fmt::format("{}{} = {} in place of {}", text.empty() ? "" : "; ", q.name,
                          text_of(q, study, said), text_of(q, study, wanted));
  }
  return text;
}

}  // namespace mpmstudy
