#include "runner/study/written_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

/// What stands behind the number of "10 um"; "" if there is none.
std::string unit_text(std::string_view text) {
  const auto skip = [&] {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '+'))
      text.remove_prefix(1);
  };
  skip();
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return "";
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  skip();
  return std::string(text.substr(0, text.find_last_not_of(" \t") + 1));
}

const WrittenUnit* unit_for(std::string_view si_unit, std::string_view parameter, const WrittenUnits& units) {
  const auto written = [&](std::string_view name) -> const WrittenUnit* {
    const mpm::Quantity* row = mpm::find_quantity(name);
    const auto found = row && row->unit == si_unit ? units.find(std::string(name)) : units.end();
    return found == units.end() ? nullptr : &found->second;
  };
  const mpm::Quantity* row = mpm::find_quantity(parameter);
  if (const WrittenUnit* own = written(parameter)) return own;
  if (const WrittenUnit* other = row ? written(row->alternative) : nullptr) return other;
  if (si_unit == "1") return nullptr;  // degrees of an angle are not those of a ratio
  for (const auto& [name, unit] : units)
    if (written(name)) return &unit;
  return nullptr;
}

/// "2.5e-07 m" in a unit of the file; "" if the text is not a number and the SI unit of a quantity.
std::string quantity_in_written_unit(std::string_view text, std::string_view parameter,
                                     const WrittenUnits& units) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return "";
  std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  if (!unit.starts_with(' ')) return "";
  unit.remove_prefix(1);
  if (std::ranges::none_of(mpm::quantities(), [&](const mpm::Quantity& q) { return q.unit == unit; }))
    return "";
  return in_written_unit(number, unit, parameter, units);
}

}  // namespace

std::string in_unit(double si, const WrittenUnit& unit) {
  // 12 digits: without what the conversion to SI and back leaves.
  return fmt::format("{:.12g} {}", (si - unit.offset) / unit.slope, unit.text);
}

std::string in_written_unit(double si, std::string_view si_unit, std::string_view parameter,
                            const WrittenUnits& units) {
  const WrittenUnit* unit = unit_for(si_unit, parameter, units);
  if (!unit || !std::isfinite(si)) return readable(si, si_unit);
  return in_unit(si, *unit);
}

std::string in_written_units(std::string_view message, std::string_view parameter,
                             const WrittenUnits& units) {
  if (std::string whole = quantity_in_written_unit(message, parameter, units); !whole.empty()) return whole;
  std::string text;
  while (!message.empty()) {
    const auto open = message.find('('), close = message.find(')', open);
    if (close == std::string_view::npos) break;
    const std::string_view inside = message.substr(open + 1, close - open - 1);
    const std::string quantity = quantity_in_written_unit(inside, parameter, units);
    text.append(message.substr(0, open + 1)).append(quantity.empty() ? inside : quantity).append(")");
    message.remove_prefix(close + 1);
  }
  return text.append(message);
}

std::optional<WrittenUnit> written_unit(const Value& value, std::string_view si_unit, const Units& units) {
  std::string text;
  if (const Table* table = value.table()) {
    const Entry* unit = table->find("unit");
    if (unit && unit->value.string()) text = *unit->value.string();
  } else if (const List* list = value.list()) {
    return list->empty() ? std::nullopt : written_unit(list->front(), si_unit, units);
  } else if (const std::string* written = value.string()) {
    text = unit_text(*written);
  }
  if (text.empty() || text == "1") return std::nullopt;
  const auto conversion = units.conversion(text, si_unit);
  const auto* to_si = std::get_if<Conversion>(&conversion);
  if (!to_si) return std::nullopt;
  if (to_si->shift) return WrittenUnit{text, std::pow(10.0, *to_si->shift), 0};
  return WrittenUnit{text, to_si->slope, to_si->offset};
}

}  // namespace mpmstudy
