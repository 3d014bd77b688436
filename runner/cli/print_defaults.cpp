#include "runner/cli/print_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

/// "scheme gimp", "area_every 50 ps", or "area_every varies" where the jobs differ.
template <class Row>
std::string default_in_force(const Row& row, const std::vector<mpm::Scene>& scenes) {
  const bool same = std::ranges::all_of(
      scenes, [&](const mpm::Scene& scene) { return row.get(scene) == row.get(scenes.front()); });
  return std::string(row.name) + " " + (same ? readable(row, scenes.front()) : "varies");
}

/// The scenes of the jobs, each with its material of that number in the place of its first.
std::vector<mpm::Scene> scenes_of(const Plan& plan, std::size_t material) {
  std::vector<mpm::Scene> scenes;
  for (const Job& job : plan.jobs)
    if (material < mpm::material_count(job.scene)) {
      scenes.push_back(job.scene);
      scenes.back().material = mpm::material_of(job.scene, material);
    }
  return scenes;
}

void print_defaults_in(mpm::Section section, const std::string& title, mpm::SceneKind kind,
                       const std::vector<std::string>& given, const std::vector<mpm::Scene>& scenes) {
  std::string line;
  const auto add = [&](const auto& row) {
    if (row.section != section || !row.belongs_to(kind) || std::ranges::find(given, row.name) != given.end())
      return;
    line += (line.empty() ? "" : ", ") + default_in_force(row, scenes);
  };
  for (const mpm::Quantity& row : mpm::quantities())
    if (!row.required) add(row);
  for (const mpm::Choice& row : mpm::choices()) add(row);
  if (!line.empty()) fmt::print("  {}: {}\n", title, line);
}

}  // namespace

void print_defaults(const Study& study, const Plan& plan) {
  fmt::print("Not in the file, so by default:\n");
  const auto scenes = scenes_of(plan, 0);
  const auto print = [&](mpm::Section section, const std::string& title) {
    print_defaults_in(section, title, study.kind, study.given, scenes);
  };
  print(mpm::Section::top, "top of the file");
  print(mpm::Section::parameters, "parameters");
  const bool composed = mpm::kind_of(study.kind).is_composed;
  const bool of_study = !composed || !study.material_place.empty();  // number 0 is the study's own
  if (of_study)
    print(mpm::Section::material, "material (" + default_in_force(mpm::material_choice(), scenes) + ")");
  for (std::size_t m = of_study ? 1 : 0; composed; ++m) {
    const auto of_material = scenes_of(plan, m);
    if (of_material.empty()) break;
    print_defaults_in(mpm::Section::material, "material " + of_material.front().material.name, study.kind, {},
                      of_material);
  }
  print(mpm::Section::numerics, "numerics");
  print(mpm::Section::measure, "measure");
}

}  // namespace mpmstudy
