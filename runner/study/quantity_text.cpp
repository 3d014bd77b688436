#include "runner/study/quantity_text.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace mpmstudy {
namespace {

constexpr std::string_view infinite = "infinite";

bool may_be_infinite(const Expected& expected) {
  return expected.range == mpm::Range::non_negative_or_infinite;
}

std::string_view adjective(mpm::Range range) {
  switch (range) {
    case mpm::Range::positive:
      return "positive ";
    case mpm::Range::non_negative:
    case mpm::Range::non_negative_or_infinite:
      return "non-negative ";
    case mpm::Range::count:
      return "positive whole ";
    case mpm::Range::any:
      return "";
  }
  return "";
}

std::string example(std::string_view unit) {
  if (unit == "m") return "10 um";
  if (unit == "s") return "16 ns";
  if (unit == "Pa") return "120 MPa";
  if (unit == "m/s") return "200 m/s";
  return "300 " + std::string(unit);
}

Refusal refuse(std::string wrong, const Expected& expected) {
  return {std::move(wrong), "allowed: " + allowed_quantity(expected)};
}

/// Decimal text in a known unit, to SI.
Number convert(std::string_view number, const Conversion& conversion, const Expected& expected) {
  if (number.starts_with('+')) number.remove_prefix(1);
  const auto si = conversion(number);
  if (!si) return refuse("out of the range of numbers", expected);
  return in_range(*si, expected);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string allowed_quantity(const Expected& expected) {
  const std::string number = "a " + std::string(adjective(expected.range)) + "number";
  if (expected.unit == "1") return number;
  return number + " with a unit that converts to " + std::string(expected.unit) + ", such as \"" +
         example(expected.unit) + "\"" +
         (may_be_infinite(expected) ? ", or \"" + std::string(infinite) + "\"" : "");
}

Number in_range(double si, const Expected& expected) {
  constexpr double largest_count = 1e6;  // far beyond any use, and safely an int
  if (!std::isfinite(si)) return refuse("not a finite number", expected);
  if (expected.range == mpm::Range::positive && !(si > 0))
    return refuse(si == 0 ? "zero" : "negative", expected);
  if ((expected.range == mpm::Range::non_negative || may_be_infinite(expected)) && si < 0)
    return refuse("negative", expected);
  if (expected.range == mpm::Range::count && (si < 1 || si > largest_count || si != std::floor(si)))
    return refuse("not a count", expected);
  return si + 0.0;  // -0 is 0
}

Number read_number(const Value& value, const Conversion& conversion, const Expected& expected) {
  if (!value.is_number())
    return Refusal{"not a number", "allowed: a plain number; its unit stands in unit = \"...\""};
  if (const auto* number = std::get_if<double>(&value.data); number && !std::isfinite(*number))
    return refuse("not a finite number", expected);
  return convert(value.number_text(), conversion, expected);
}

Number read_quantity(const Value& value, const Expected& expected, const Units& units) {
  if (value.is_number()) {
    if (expected.unit != "1") return refuse("no unit", expected);
    return read_number(value, Conversion{0, 1, 0}, expected);
  }
  const std::string* written = value.string();
  if (!written) return refuse("not a quantity", expected);

  const std::string_view text = trimmed(*written);
  if (may_be_infinite(expected) && text == infinite) return std::numeric_limits<double>::infinity();
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc::invalid_argument) return refuse("not a number with a unit", expected);
  if (error != std::errc()) return refuse("out of the range of numbers", expected);
  if (!std::isfinite(number)) return refuse("not a finite number", expected);

  const auto length = static_cast<std::size_t>(end - digits.data());
  const std::string_view unit = trimmed(digits.substr(length));
  if (unit.empty() && expected.unit != "1") return refuse("no unit", expected);
  const auto conversion = units.conversion(unit, expected.unit);
  if (const auto* wrong = std::get_if<std::string>(&conversion)) return refuse(*wrong, expected);
  const auto& known = std::get<Conversion>(conversion);
  if (expected.difference && !known.shift && known.offset != 0)
    return Refusal{"is a difference, and the unit has a zero point of its own",
                   "allowed: a width in " + std::string(expected.unit)};
  return convert(digits.substr(0, length), known, expected);
}

}  // namespace mpmstudy
