#pragma once
/// Numbers for people.
#include <string>
#include <string_view>

#include "libmpm/scene/parameters.hpp"

namespace mpmstudy {

/// An SI value with a prefix that keeps its number short: (1e-5, "m") -> "10 um"; a pure number: "0.33".
/// Six significant digits.
std::string readable(double value, std::string_view unit);

/// The value of a row of the parameter table in a scene: "10 um", "gimp".
std::string readable(const mpm::Quantity&, const mpm::Scene&);
std::string readable(const mpm::Choice&, const mpm::Scene&);

}  // namespace mpmstudy
