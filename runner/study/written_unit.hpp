#pragma once
#include <optional>

#include "runner/study/document.hpp"
#include "runner/study/study.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// The unit of a quantity as its value writes it: of "10 um" and of { values = [1, 2], unit = "um" } it is
/// "um", of a list that of its first value. Empty: the value has none, or is no quantity of this SI unit.
std::optional<WrittenUnit> written_unit(const Value&, std::string_view si_unit, const Units&);

/// "0.25 um" of 2.5e-07.
std::string in_unit(double si, const WrittenUnit&);

/// The same: in the unit in which the file writes the parameter or its alternative, else another
/// quantity of this SI unit, else with a prefix that keeps it short.
std::string in_written_unit(double si, std::string_view si_unit, std::string_view parameter,
                            const WrittenUnits&);

/// A message of the library about a parameter, in which a quantity is the whole text or stands in parentheses
/// ("at most cavity_radius (2.5e-07 m): ..."), with these quantities in units of the file.
std::string in_written_units(std::string_view message, std::string_view parameter, const WrittenUnits&);

}  // namespace mpmstudy
