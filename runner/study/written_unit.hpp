#pragma once
#include <optional>

#include "runner/study/document.hpp"
#include "runner/study/study.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// The unit of a quantity as its value writes it: of "10 um" and of { values = [1, 2], unit = "um" } it is
/// "um", of a list that of its first value. Empty: the value has none, or is no quantity of this SI unit.
std::optional<WrittenUnit> written_unit(const Value&, std::string_view si_unit, const Units&);

}  // namespace mpmstudy
