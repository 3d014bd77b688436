#include "analysis/log_axis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace analysis {

std::string log_axis(const std::string& axis, double low, double high) {
  constexpr double room = 0.04;  // of the axis, at either end
  const double more = high > low ? std::pow(high / low, room) : 1.1;
  const double from = low / more, to = high * more;
  const double decades = std::log10(to / from);
  std::string numbers;
  const auto add = [&](double at) {
    if (at >= from && at <= to)
      numbers += fmt::format("{}'{:g}' {:.9g}", numbers.empty() ? "" : ", ", at, at);
  };
  if (decades < 0.3) {
    const double power = std::pow(10, std::floor(std::log10((to - from) / 2)));  // two steps or more
    const double step = power * ((to - from) / power > 10 ? 5 : (to - from) / power > 4 ? 2 : 1);
    for (double k = std::ceil(from / step); k * step <= to; ++k) add(k * step);
  } else {
    const std::vector<int> digits = decades < 1.05 ? std::vector{1, 2, 3, 4, 5, 6, 7, 8, 9}
                                    : decades < 4  ? std::vector{1, 2, 5}
                                                   : std::vector{1};
    for (int power = static_cast<int>(std::floor(std::log10(from))); std::pow(10, power) <= to; ++power)
      for (const int digit : digits) add(digit * std::pow(10, power));
  }
  return fmt::format("set logscale {0}\nset {0}range [{1:.9g}:{2:.9g}]\nset {0}tics ({3})\n", axis, from, to,
                     numbers);
}

}  // namespace analysis
