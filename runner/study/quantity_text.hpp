#pragma once
/// From "10 um" to 1e-5: one number with its unit, checked.
#include <string>
#include <string_view>
#include <variant>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// A number in SI, or why there is none.
using Number = std::variant<double, Refusal>;

/// What a quantity must be.
struct Expected {
  std::string_view unit;  ///< SI; "1": a pure number
  mpm::Range range = mpm::Range::any;
  /// A width, not a place: units with a zero point of their own (degC) have none.
  bool difference = false;
};

/// Without the blanks and tabs before and behind it.
std::string_view trimmed(std::string_view);

/// Reads one value: "10 um", or a plain number where the unit is "1".
Number read_quantity(const Value&, const Expected&, const Units&);

/// Reads one plain number that is written in a unit which stands elsewhere ({ values = [...], unit = "um" }).
Number read_number(const Value&, const Conversion&, const Expected&);

/// The value, unless its range forbids it.
Number in_range(double si, const Expected&);

/// "a positive number with a unit that converts to m/s, such as \"200 m/s\"".
std::string allowed_quantity(const Expected&);

}  // namespace mpmstudy
