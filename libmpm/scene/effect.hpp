#pragma once
/// Parameters that have an effect under a condition only, such as the spall strength, which nothing reads but
/// tension = "cutoff". Every other row of the table of parameters decides bits of some stored result in every
/// scene of its kinds. Checked by tests/libmpm/scene/effect_test.cpp, which runs scenes with and without.
#include <span>
#include <string_view>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Measures::detached_for where a study says nothing: a sixteenth of end_time (1 ns of 16 ns) [s].
constexpr double default_detached_for(const Scene& s) { return s.end_time / 16; }

/// When a parameter has an effect.
struct Condition {
  std::string_view parameter;     ///< a quantity or a choice of parameters.hpp
  std::string_view when;          ///< for people: "tension = \"cutoff\""
  bool (*holds)(const Scene&);    ///< whether it has an effect in this scene
  double (*inert)(const Scene&);  ///< what stands in a job's key where it has none; of a choice: the index
};

std::span<const Condition> conditions();
const Condition* condition_of(std::string_view parameter);  ///< null: it always has an effect

}  // namespace mpm
