#include "runner/study/job_quantity.hpp"

#include <cmath>

#include "runner/study/decimal.hpp"

namespace mpmstudy {

JobQuantity::JobQuantity(std::string_view key, const Value& value, const Expected& expected,
                         std::variant<double, Expression> number)
    : place_(value.place),
      key_(key),
      written_(value.written()),
      expected_(expected),
      number_(std::move(number)) {}

std::optional<JobQuantity> JobQuantity::read(std::string_view key, const Value& value, const Value& whole,
                                             const Expected& expected, const Units& units,
                                             const KnownParameters& known, Mistakes& mistakes) {
  auto read = read_number_or_expression(key, value, whole, expected, units, known, mistakes);
  if (const double* si = std::get_if<double>(&read)) return JobQuantity(key, value, expected, *si);
  if (auto* expression = std::get_if<Expression>(&read))
    return JobQuantity(key, value, expected, std::move(*expression));
  return std::nullopt;
}

std::optional<JobQuantity> JobQuantity::read(std::string_view key, const Value& value,
                                             const Expected& expected, const Units& units,
                                             const KnownParameters& known, Mistakes& mistakes) {
  return read(key, value, value, expected, units, known, mistakes);
}

std::optional<JobQuantity> JobQuantity::read_part(std::string_view key, const Value& whole,
                                                  std::string_view part, const Expected& expected,
                                                  const Units& units, const KnownParameters& known,
                                                  Mistakes& mistakes) {
  Value value{whole.place, std::string(part)};
  // --set has no columns
  if (value.place.line > 0 && !part.empty())
    value.place.column += static_cast<std::uint32_t>(part.data() - whole.string()->data());
  return read(key, value, whole, expected, units, known, mistakes);
}

std::optional<double> JobQuantity::value(const ValueOf& of, Mistakes& mistakes) const {
  if (const double* si = constant()) return *si;
  double si = std::get<Expression>(number_).value(of);
  // times are compared with each other: two that differ by rounding are one
  if (expected_.unit == "s" && std::isfinite(si)) si = round_to_12_digits(si);
  return expression_value(place_, key_, written_, si, expected_, mistakes);
}

}  // namespace mpmstudy
