#include "runner/status/label.hpp"

#include <fmt/format.h>

#include <cmath>

#include "libmpm/scene/parameters.hpp"

namespace mpmstudy {
namespace {

struct Prefix {
  double factor;
  const char* sign;
};
constexpr Prefix prefixes[] = {{1e9, "G"},  {1e6, "M"},  {1e3, "k"},  {1, ""},
                               {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}, {1e-12, "p"}};

}  // namespace

std::string readable(double value, const std::string& unit) {
  if (unit == "1") return fmt::format("{:.4g}", value);
  const bool scales = unit == "m" || unit == "s" || unit == "Pa" || unit == "J";
  if (!scales || value == 0 || !std::isfinite(value)) return fmt::format("{:.4g} {}", value, unit);
  for (const auto& prefix : prefixes)
    if (std::abs(value) >= prefix.factor * 0.99995)
      return fmt::format("{:.4g} {}{}", value / prefix.factor, prefix.sign, unit);
  return fmt::format("{:.4g} {}", value, unit);
}

std::string label_of(const mpm::Scene& scene, std::span<const std::string> swept) {
  std::string text;
  for (const auto& name : swept) {
    std::string value;
    if (const auto* quantity = mpm::find_quantity(name))
      value = readable(quantity->get(scene), std::string(quantity->unit));
    else if (const auto* choice = mpm::find_choice(name))
      value = choice->allowed[choice->get(scene)];
    else
      continue;
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  }
  return text;
}

std::string readable_duration(double seconds) {
  if (!(seconds >= 0)) return "?";
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string readable_rate(double updates_per_second) {
  return fmt::format("{:.2f} M/s", updates_per_second * 1e-6);
}

}  // namespace mpmstudy
