#include "runner/study/decimal.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace mpmstudy {

std::optional<double> scaled_decimal(std::string_view text, int shift) {
  const auto e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  int exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = text.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    if (exponent > 10'000 || exponent < -10'000) return std::nullopt;
  }
  const std::string moved = std::string(mantissa) + "e" + std::to_string(exponent + shift);
  double value = 0;
  const auto [end, error] = std::from_chars(moved.data(), moved.data() + moved.size(), value);
  if (error != std::errc() || end != moved.data() + moved.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string shortest_text(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, result.ptr);
}

double round_to_12_digits(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, 11);
  double rounded = value;
  std::from_chars(buffer, result.ptr, rounded);
  return rounded;
}

double without_rounding(double value) {
  constexpr double rounding = 1e-13;  // of a difference of lengths that are up to a thousand times as large
  const double rounded = round_to_12_digits(value);
  return std::abs(rounded - value) <= rounding * std::abs(value) ? rounded : value;
}

}  // namespace mpmstudy
