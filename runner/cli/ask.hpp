#pragma once
/// Asks before a run that needs more than this machine has, or that takes very long.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runner/plan/resources.hpp"

namespace mpmstudy {

/// A predicted time above this is asked for [s].
inline constexpr double longest_unasked = 12 * 3600;

/// Memory that a new process can have: what the machine has free, within the bound of its control group.
/// Empty if this system does not say. [bytes]
std::optional<double> free_memory();

/// What is too much of the demand, in words; "" if nothing is. `free`: bytes, empty: unknown.
std::string too_much(const Demand&, std::optional<double> free);

/// "1.5 GB".
std::string readable_bytes(double bytes);

/// Asks on the terminal whether to go on; without one, or if the answer is not yes, throws StudyError, which
/// names the number and --yes. Does nothing if `too_much` is empty.
void ask(const std::string& too_much);

/// Says each line on standard error, "warning: " before it.
void print_warnings(const std::vector<std::string>&);

}  // namespace mpmstudy
