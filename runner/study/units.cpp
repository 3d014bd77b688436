#include "runner/study/units.hpp"

#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "runner/study/decimal.hpp"

namespace mpmstudy {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

/// Letters, and digits as exponents only. UDUNITS also takes factors ("5um") and origins ("s since 1990"):
/// a second number in a quantity is a mistake, never meant.
bool is_plain(std::string_view unit) {
  char before = ' ';
  for (const char c : unit) {
    if (c == '@' || std::iscntrl(static_cast<unsigned char>(c)))
      return false;  // it prints those that it refuses
    if (std::isdigit(static_cast<unsigned char>(c))) {
      const bool exponent =
          std::isalnum(static_cast<unsigned char>(before)) || before == '^' || before == '-' || before == '+';
      if (!exponent) return false;
    }
    before = c;
  }
  return true;
}

/// n if factor is 10^n, up to the rounding that UDUNITS's own arithmetic leaves.
std::optional<int> power_of_ten(double factor) {
  const double n = std::round(std::log10(factor));
  if (!std::isfinite(n) || std::abs(n) > 300) return std::nullopt;
  const double exact = *scaled_decimal("1", static_cast<int>(n));
  if (std::abs(factor - exact) > 1e-14 * exact) return std::nullopt;
  return static_cast<int>(n);
}

}  // namespace

struct Units::System {
  ut_system* handle = nullptr;
  ~System() { ut_free_system(handle); }
  Unit parse(std::string_view text) const {
    if (text == "deg") text = "degree";  // what most people write; UDUNITS knows the long word only
    return Unit(ut_parse(handle, std::string(text).c_str(), UT_UTF8));
  }
};

std::optional<double> Conversion::operator()(std::string_view number) const {
  if (shift) return scaled_decimal(number, *shift);
  const auto value = scaled_decimal(number, 0);
  if (!value) return std::nullopt;
  const double result = slope * *value + offset;
  return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

Units::Units() : system_(std::make_unique<System>()) {
  ut_set_error_message_handler(ut_ignore);  // its messages are not for the user's terminal
  system_->handle = ut_read_xml(nullptr);
  if (system_->handle == nullptr)
    throw std::runtime_error(
        "the unit database of UDUNITS-2 (udunits2.xml, Debian package libudunits2-data) cannot be read");
}

Units::~Units() = default;

std::variant<Conversion, std::string> Units::conversion(std::string_view from, std::string_view to) const {
  const std::string quoted = "'" + std::string(from) + "'";
  if (!is_plain(from)) return quoted + " is not a unit";
  const Unit source = system_->parse(from);
  if (!source) return quoted + " is not a unit";
  const Unit target = system_->parse(to);
  if (!target) throw std::logic_error("parameter table: unit '" + std::string(to) + "'");
  const std::string wrong =
      quoted + (to == "1" ? " is not a pure number" : " is not a unit of this quantity");
  if (!ut_are_convertible(source.get(), target.get())) return wrong;
  const Converter converter(ut_get_converter(source.get(), target.get()));
  if (!converter) return wrong;

  Conversion result;
  result.offset = cv_convert_double(converter.get(), 0.0);
  result.slope = cv_convert_double(converter.get(), 1.0) - result.offset;
  // UDUNITS also turns 1/s into s (by the reciprocal) and logarithmic units: not what a study means.
  const double two = cv_convert_double(converter.get(), 2.0);
  const double straight = 2 * result.slope + result.offset;
  if (!std::isfinite(result.offset) || !(result.slope > 0) ||
      std::abs(two - straight) > 1e-12 * std::abs(two))
    return wrong;
  if (result.offset == 0) result.shift = power_of_ten(result.slope);
  return result;
}

/// UDUNITS writes a unit in base units as "1e-06 m", "1000 kg.m-1.s-2", "K @ 273.15".
std::optional<Dimension> Units::dimension(std::string_view text) const {
  if (text == "1") return Dimension{};
  if (!is_plain(text)) return std::nullopt;
  const Unit unit = system_->parse(text);
  std::array<char, 256> buffer{};
  if (!unit || ut_format(unit.get(), buffer.data(), buffer.size(), UT_ASCII | UT_DEFINITION) <= 0)
    return std::nullopt;
  std::string definition(buffer.data());
  definition.resize(std::min(definition.find('@'), definition.size()));
  std::ranges::replace(definition, '.', ' ');
  std::istringstream words(definition);
  Dimension dimension;
  for (std::string word; words >> word;) {
    const std::size_t letters = word.find_first_of("-0123456789");
    const std::string base = word.substr(0, letters);
    if (base.empty() || base == "rad") continue;  // the factor; an angle
    const auto k = std::ranges::find(Dimension::units, base);
    if (k == Dimension::units.end()) return std::nullopt;
    const int power = letters == word.npos ? 1 : std::stoi(word.substr(letters));
    dimension.powers[static_cast<std::size_t>(k - Dimension::units.begin())] += power;
  }
  return dimension;
}

}  // namespace mpmstudy
