#include "runner/study/quantity_reader.hpp"

#include <fmt/format.h>

namespace mpmstudy {

std::optional<Expression> parse_expression(std::string_view key, const Value& value, const Units& units,
                                           const KnownParameters& known, Mistakes& mistakes,
                                           Comparison comparison) {
  auto read = Expression::read(*value.string(), units, known.dimension, known.names, comparison);
  if (const auto* refusal = std::get_if<ExpressionRefusal>(&read)) {
    Place place = value.place;
    if (place.line > 0) place.column += static_cast<std::uint32_t>(1 + refusal->at);  // behind the quote
    mistakes.add(place, key, value.written(), *refusal);
    return std::nullopt;
  }
  return std::move(std::get<Expression>(read));
}

std::optional<Expression> read_expression(std::string_view key, const Value& value, const Expected& expected,
                                          const Units& units, const KnownParameters& known,
                                          Mistakes& mistakes) {
  auto expression = parse_expression(key, value, units, known, mistakes);
  if (!expression || expression->has(units.dimension(expected.unit).value_or(Dimension{}))) return expression;
  mistakes.add(key, value,
               {"is a quantity in " + expression->dimension().text(),
                "allowed: " + allowed_quantity(expected) + ", or an expression of that unit"});
  return std::nullopt;
}

std::optional<double> expression_value(const Place& place, std::string_view key, std::string_view written,
                                       double si, const Expected& expected, Mistakes& mistakes) {
  const Number number = in_range(si, expected);
  if (const auto* refusal = std::get_if<Refusal>(&number)) {
    mistakes.add(place, key, written,
                 {fmt::format("makes {:.6g} {}, {}", si, expected.unit, refusal->wrong), refusal->allowed});
    return std::nullopt;
  }
  return std::get<double>(number);
}

NumberOrExpression read_number_or_expression(std::string_view key, const Value& value, const Value& whole,
                                             const Expected& expected, const Units& units,
                                             const KnownParameters& known, Mistakes& mistakes) {
  const Number number = read_quantity(value, expected, units);
  if (const double* si = std::get_if<double>(&number)) return *si + 0.0;  // -0 is 0
  const std::string* text = value.string();
  // without a parameter in it, too, it may be a sum: "1 um + 2 um"
  const auto is_sum = [&] {
    return text->find_first_of("+-*/^(", 1) != std::string::npos &&
           std::holds_alternative<Expression>(Expression::read(*text, units, known.dimension, known.names));
  };
  if (!text || (names_in(*text).empty() && !is_sum()))
    mistakes.add(key, whole, std::get<Refusal>(number));
  else if (auto expression = read_expression(key, value, expected, units, known, mistakes))
    return std::move(*expression);
  return {};
}

std::optional<double> QuantityReader::read(std::string_view key, const Value& value, const Expected& expected,
                                           const ValueOf& of, Mistakes& mistakes) {
  const std::string* text = value.string();
  const auto known = text ? read_.find({*text, std::string(expected.unit)}) : read_.end();
  NumberOrExpression read =
      known != read_.end() ? NumberOrExpression(known->second)
                           : read_number_or_expression(key, value, value, expected, units_, known_, mistakes);
  const auto* expression = std::get_if<Expression>(&read);
  if (text && expression) read_.try_emplace({*text, std::string(expected.unit)}, *expression);
  if (const double* si = std::get_if<double>(&read)) return *si;
  if (!expression) return std::nullopt;
  return expression_value(value.place, key, value.written(), expression->value(of), expected, mistakes);
}

}  // namespace mpmstudy
