#pragma once
/// Numbers as people write them. A unit that is a power of ten moves the decimal point and nothing else, so
/// "10 um", "0.01 mm" and "1e-5 m" are the same double and give the same job.
#include <optional>
#include <string>
#include <string_view>

namespace mpmstudy {

/// The double nearest to text * 10^shift; `text` is a decimal number ("10", "-0.5", "1e-5").
/// Empty if it is not one, or if the result overflows or underflows.
std::optional<double> scaled_decimal(std::string_view text, int shift);

/// The shortest text that reads back as `value`: "0.1", "1e-05".
std::string shortest_text(double value);

/// `value` rounded to 12 significant digits: points that a sweep computes are rounded so, which makes them
/// readable (0.3, not 0.30000000000000004) and independent of the mathematics library of the machine.
double round_to_12_digits(double value);

/// `value` without the last digits that computing it has left: 4e-06 for 4.000000000000001e-06, 1.3e-06 for
/// 1.2999999999999998e-06. What is no number of twelve digits but for rounding stays as it is. For
/// columns of the catalog and for people, never for what keys are made of.
double without_rounding(double value);

}  // namespace mpmstudy
