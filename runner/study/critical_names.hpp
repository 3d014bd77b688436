#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mpmstudy {

/// What a [search] finds, as fits and figures ask for it: "critical_yield_stress" is the middle of the
/// bracket on one cell, "critical_yield_stress_extrapolated" the value for cells of size 0. A speed is
/// "critical_speed" and "critical_speed_extrapolated" as well.
enum class CriticalResult { bracket, extrapolated };

/// Every name that a search for `quantity` has.
std::vector<std::string> critical_names(std::string_view quantity);

/// Empty if the name is none of those of a search for `quantity`; "": of a search for any quantity.
std::optional<CriticalResult> critical_result(std::string_view name, std::string_view quantity = "");

/// Whether two names say the same result of one study.
bool same_result(std::string_view, std::string_view);

}  // namespace mpmstudy
