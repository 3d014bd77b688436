#include "runner/study/readable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mpmstudy {

std::string readable(double value, std::string_view unit) {
  constexpr std::string_view prefixed[] = {"m", "s", "Pa"};
  constexpr std::string_view prefixes[] = {"f", "p", "n", "u", "m", "", "k", "M", "G", "T"};
  constexpr int none = 5;                                              // index of ""
  if (std::isinf(value)) return value > 0 ? "infinite" : "-infinite";  // as study files write it
  if (unit == "1") return fmt::format("{:.6g}", value);
  if (std::find(std::begin(prefixed), std::end(prefixed), unit) == std::end(prefixed) || value == 0 ||
      !std::isfinite(value))
    return fmt::format("{:.6g} {}", value, unit);
  // Six digits first: 999999.9 rounds up into the next prefix.
  const double rounded = std::stod(fmt::format("{:.5e}", std::abs(value)));
  int step = static_cast<int>(std::floor(std::log10(rounded) / 3 + 1e-9)) + none;
  if (unit == "s" || unit == "m") step = std::min(step, none);  // nobody writes Ms or Mm
  step = std::clamp(step, 0, static_cast<int>(std::size(prefixes)) - 1);
  return fmt::format("{:.6g} {}{}", value * std::pow(10.0, 3 * (none - step)), prefixes[step], unit);
}

std::string readable(const mpm::Quantity& row, const mpm::Scene& scene) {
  return readable(row.get(scene), row.unit);
}

std::string readable(const mpm::Choice& row, const mpm::Scene& scene) {
  return std::string(row.allowed[row.get(scene)]);
}

}  // namespace mpmstudy
