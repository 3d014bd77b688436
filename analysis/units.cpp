#include "analysis/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace analysis {
namespace {

struct Scale {
  std::string_view si, text;
  double size;  ///< in SI
};

/// For each SI unit from the largest to the smallest.
constexpr std::array scales = {
    Scale{"m", "m", 1},
    Scale{"m", "mm", 1e-3},
    Scale{"m", "µm", 1e-6},
    Scale{"m", "nm", 1e-9},
    Scale{"m^2", "m²", 1},
    Scale{"m^2", "mm²", 1e-6},
    Scale{"m^2", "µm²", 1e-12},
    Scale{"s", "s", 1},
    Scale{"s", "ms", 1e-3},
    Scale{"s", "µs", 1e-6},
    Scale{"s", "ns", 1e-9},
    Scale{"s", "ps", 1e-12},
    Scale{"m/s", "km/s", 1e3},
    Scale{"m/s", "m/s", 1},
    Scale{"Pa", "GPa", 1e9},
    Scale{"Pa", "MPa", 1e6},
    Scale{"Pa", "kPa", 1e3},
    Scale{"Pa", "Pa", 1},
    Scale{"J/m^3", "GJ/m³", 1e9},
    Scale{"J/m^3", "MJ/m³", 1e6},
    Scale{"J/m^3", "kJ/m³", 1e3},
    Scale{"J/kg", "MJ/kg", 1e6},
    Scale{"J/kg", "kJ/kg", 1e3},
    Scale{"J/kg", "J/kg", 1},
    Scale{"kg/m^3", "kg/m³", 1},
    Scale{"kg/m", "µg/m", 1e-9},
    Scale{"m^3", "m³", 1},
    Scale{"m^3", "mm³", 1e-9},
    Scale{"m^3", "µm³", 1e-18},
    Scale{"kg", "kg", 1},
    Scale{"kg", "µg", 1e-9},
    Scale{"kg", "ng", 1e-12},
    Scale{"K", "K", 1},
    Scale{"1", "", 1},
    Scale{"N/m", "MN/m", 1e6},
    Scale{"N/m", "kN/m", 1e3},
    Scale{"N/m", "N/m", 1},
    Scale{"N", "kN", 1e3},
    Scale{"N", "N", 1},
    Scale{"N", "mN", 1e-3},
    Scale{"N", "µN", 1e-6},
    Scale{"N/rad", "kN/rad", 1e3},
    Scale{"N/rad", "N/rad", 1},
    Scale{"N/rad", "mN/rad", 1e-3},
    Scale{"N/rad", "µN/rad", 1e-6},
    Scale{"J/m", "kJ/m", 1e3},
    Scale{"J/m", "J/m", 1},
    Scale{"J/m", "mJ/m", 1e-3},
    Scale{"J/m", "µJ/m", 1e-6},
    Scale{"J", "kJ", 1e3},
    Scale{"J", "J", 1},
    Scale{"J", "mJ", 1e-3},
    Scale{"J", "µJ", 1e-6},
    Scale{"J", "nJ", 1e-9},
    Scale{"J/rad", "kJ/rad", 1e3},
    Scale{"J/rad", "J/rad", 1},
    Scale{"J/rad", "mJ/rad", 1e-3},
    Scale{"J/rad", "µJ/rad", 1e-6},
    Scale{"J/rad", "nJ/rad", 1e-9},
    Scale{"kg/rad", "kg/rad", 1},
    Scale{"kg/rad", "µg/rad", 1e-9},
    Scale{"kg/rad", "ng/rad", 1e-12},
    Scale{"kg/s", "kg/s", 1},
    Scale{"kg/s", "g/s", 1e-3},
    Scale{"kg/s", "mg/s", 1e-6},
    Scale{"kg m/s", "kg m/s", 1},
    Scale{"kg m/s", "g m/s", 1e-3},
    Scale{"kg m/s", "µg m/s", 1e-9},
    Scale{"kg m/s/rad", "kg m/s/rad", 1},
    Scale{"kg m/s/rad", "g m/s/rad", 1e-3},
    Scale{"kg m/s/rad", "µg m/s/rad", 1e-9},
    Scale{"rad/s", "Mrad/s", 1e6},
    Scale{"rad/s", "krad/s", 1e3},
    Scale{"rad/s", "rad/s", 1},
};

}  // namespace

std::string with_powers(std::string_view unit) {
  std::string text;
  for (const char c : unit) {
    const bool power = c >= '0' && c <= '9' && !text.empty() && text.back() >= 'A';
    if (power && text.back() != '^') text += '^';
    text += c;
  }
  return text;
}

std::string_view without_unit(std::string_view name, std::string_view unit) {
  std::string end = "_";
  for (const char c : unit)
    if (c != '^') end += c == '/' ? '_' : c;
  return name.ends_with(end) ? name.substr(0, name.size() - end.size()) : name;
}

bool is_known_unit(std::string_view unit) {
  return std::ranges::find(scales, with_powers(unit), &Scale::si) != scales.end();
}

QuantityLabel quantity_label(std::string_view full_name, std::string_view si_unit, std::string_view symbol,
                             std::string_view title) {
  const std::string unit = with_powers(si_unit);
  if (!title.empty()) return {std::string(title), std::string(symbol), unit};
  std::string words(without_unit(full_name, unit));
  std::ranges::replace(words, '_', ' ');
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return {words, std::string(symbol), unit};
}

DisplayUnit display_unit(std::string_view si_unit, double largest) {
  const std::string unit = with_powers(si_unit);
  const Scale* best = nullptr;
  for (const Scale& scale : scales) {
    if (scale.si != unit) continue;
    best = &scale;
    if (std::abs(largest) >= 0.5 * scale.size) break;
  }
  if (!best) return {1, std::string(si_unit)};
  return {1 / best->size, std::string(best->text)};
}

DisplayUnit fixed_unit(std::string_view si_unit, double largest) {
  if (si_unit == "Pa") return {1e-6, "MPa"};
  if (si_unit == "J/m^3") return {1e-6, "mJ/mm³"};
  return display_unit(si_unit, largest);
}

std::string axis_label(const QuantityLabel& quantity, const DisplayUnit& unit) {
  std::string label = quantity.name;
  if (!quantity.symbol.empty()) label += " " + quantity.symbol;
  if (!unit.text.empty()) label += " (" + unit.text + ")";
  return label;
}

std::string value_label(const QuantityLabel& quantity, double in_si, int digits) {
  const DisplayUnit unit = display_unit(quantity.unit, in_si);
  const std::string& name = quantity.symbol.empty() ? quantity.name : quantity.symbol;
  return fmt::format("{} = {:.{}g}{}{}", name, in_si * unit.factor, digits, unit.text.empty() ? "" : " ",
                     unit.text);
}

std::vector<std::string> value_labels(const QuantityLabel& quantity, std::span<const double> in_si) {
  constexpr int fewest_digits = 4, most_digits = 17;
  const std::set<double> values(in_si.begin(), in_si.end());
  for (int digits = fewest_digits;; ++digits) {
    std::set<std::string> distinct;
    for (const double value : values) distinct.insert(value_label(quantity, value, digits));
    if (distinct.size() < values.size() && digits < most_digits) continue;
    std::vector<std::string> labels;
    for (const double value : in_si) labels.push_back(value_label(quantity, value, digits));
    return labels;
  }
}

}  // namespace analysis
