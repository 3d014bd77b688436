#include "runner/cli/amounts.hpp"

#include <cmath>
#include <map>

#include "runner/study/document.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

double read_duration(const std::string& option, const std::string& text) {
  if (text.empty() || text == "0") return 0;
  const bool plain = text.find_first_not_of("0123456789.") == std::string::npos;
  const Value value = read_value(option, '"' + text + (plain ? " s" : "") + '"');
  const Number number = read_quantity(value, {"s", mpm::Range::positive}, Units());
  if (const auto* seconds = std::get_if<double>(&number)) return *seconds;
  throw StudyError(option + ": " + text + ": is no time; write for example \"90 s\", \"10 min\" or \"2 h\"");
}

std::uint64_t read_bytes(const std::string& option, const std::string& text) {
  if (text.empty()) return 0;
  static const std::map<std::string, double> units = {
      {"", 1},      {"B", 1},        {"kB", 1e3},     {"MB", 1e6},     {"GB", 1e9},
      {"TB", 1e12}, {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};
  std::size_t end = 0;
  double number = 0;
  try {
    number = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  const auto unit = units.find(text.substr(std::min(text.find_first_not_of(' ', end), text.size())));
  if (end == 0 || unit == units.end() || !(number > 0) || !(number * unit->second < 0x1p62))
    throw StudyError(option + ": " + text + ": is no size; write for example \"500 MB\" or \"2 GiB\"");
  return static_cast<std::uint64_t>(std::ceil(number * unit->second));
}

}  // namespace mpmstudy
