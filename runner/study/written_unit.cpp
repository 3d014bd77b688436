#include "runner/study/written_unit.hpp"

#include <charconv>
#include <cmath>

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

}  // namespace

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
  if (text.empty() || si_unit == "1") return std::nullopt;
  const auto conversion = units.conversion(text, si_unit);
  const auto* to_si = std::get_if<Conversion>(&conversion);
  if (!to_si) return std::nullopt;
  if (to_si->shift) return WrittenUnit{text, std::pow(10.0, *to_si->shift), 0};
  return WrittenUnit{text, to_si->slope, to_si->offset};
}

}  // namespace mpmstudy
