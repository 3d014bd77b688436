#pragma once
#include <string>

namespace analysis {

/// gnuplot's commands for a logarithmic axis ("x", "y") from `low` to `high`, both above zero, with a little
/// room at both ends. gnuplot's own axes end at powers of ten, and have no other number on them: a range of
/// 100 to 400 would fill half of one. Here numbers are 1, 2 and 5 times powers of ten; of a range below a
/// factor of 3, every digit.
std::string log_axis(const std::string& axis, double low, double high);

}  // namespace analysis
