#pragma once
/// Parameters that have an effect under a condition only, such as the spall strength, which nothing reads but
/// tension = "cutoff". Every other row of the table of parameters decides bits of some stored result in every
/// scene of its kinds. Checked by tests/libmpm/scene/effect_test.cpp, which runs scenes with and without.
#include <concepts>
#include <span>
#include <string_view>

#include "libmpm/material/row.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Measures::detached_for where a study says nothing: a sixteenth of end_time (1 ns of 16 ns) [s].
constexpr double default_detached_for(const Scene& s) { return s.end_time / 16; }

/// Whether a parameter has an effect in a scene: by the scene, or by its material.
class Holds {
 public:
  constexpr Holds(bool (*of_scene)(const Scene&)) : of_scene_(of_scene) {}
  constexpr Holds(const MaterialUse& use) : of_material_(use.holds) {}
  bool operator()(const Scene& s) const { return of_scene_ ? of_scene_(s) : of_material_(s.material); }

 private:
  bool (*of_scene_)(const Scene&) = nullptr;
  bool (*of_material_)(const Material&) = nullptr;
};

/// What stands in a job's key for a parameter without an effect: a function of the scene, or a number.
class Inert {
 public:
  template <class Function>
  requires std::convertible_to<Function, double (*)(const Scene&)>
  constexpr Inert(Function of_scene) : of_scene_(of_scene) {}
  constexpr Inert(double number) : number_(number) {}
  double operator()(const Scene& s) const { return of_scene_ ? of_scene_(s) : number_; }

 private:
  double (*of_scene_)(const Scene&) = nullptr;
  double number_ = 0;
};

/// When a parameter has an effect.
struct Condition {
  std::string_view parameter;  ///< a quantity or a choice of parameters.hpp
  std::string_view when;       ///< for people: "tension = \"cutoff\""
  Holds holds;
  Inert inert;  ///< what stands in a job's key where it has none; of a choice: the index
};

std::span<const Condition> conditions();
const Condition* condition_of(std::string_view parameter);  ///< null: it always has an effect

}  // namespace mpm
