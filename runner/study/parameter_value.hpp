#pragma once
/// Parameters of a scene by their names: those of the study's own, and rows of the parameter table. A study
/// whose kind of scene has not a row may use its name.
#include <optional>
#include <string>
#include <string_view>

#include "libmpm/scene/scene.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// The value of a quantity, SI. Empty: the scene has none of that name, or it is a choice.
std::optional<double> quantity_value(const mpm::Scene&, std::string_view name);
/// The unit of a quantity that the study has, SI. "": it has none of that name, or it is a choice.
std::string quantity_unit(const Study&, std::string_view name);
/// What tells scenes apart: the value of a quantity, of a choice the number of its word.
double parameter_number(const mpm::Scene&, std::string_view name);
/// For people: "10 um", "gimp". "": the scene has none of that name.
std::string readable_parameter(const mpm::Scene&, std::string_view name);

}  // namespace mpmstudy
