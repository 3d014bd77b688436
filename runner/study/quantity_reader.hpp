#pragma once
/// Quantities of a study that may be expressions of its parameters, read once and valued job by job.
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runner/study/expression.hpp"
#include "runner/study/quantity_text.hpp"

namespace mpmstudy {

/// What may stand in the expressions of a study.
struct KnownParameters {
  Expression::DimensionOf dimension;
  std::vector<std::string> names;  ///< for messages
};

/// The value of a parameter in one job [SI].
using ValueOf = std::function<double(const std::string& name)>;

/// Reads a text as an expression of any unit. Empty after adding a mistake, with the column where it is.
std::optional<Expression> parse_expression(std::string_view key, const Value&, const Units&,
                                           const KnownParameters&, Mistakes&, Comparison = Comparison::exact);

/// Reads a text as an expression of that unit. Empty after adding a mistake, with the column where it is.
std::optional<Expression> read_expression(std::string_view key, const Value&, const Expected&, const Units&,
                                          const KnownParameters&, Mistakes&);

/// What an expression comes to, where that is in range. Empty after adding a mistake.
std::optional<double> expression_value(const Place&, std::string_view key, std::string_view written,
                                       double si, const Expected&, Mistakes&);

/// A number with its unit, or an expression of that unit. Nothing after adding a mistake; of what is neither,
/// the mistake shows `whole`, which the value is a part of.
using NumberOrExpression = std::variant<std::monostate, double, Expression>;
NumberOrExpression read_number_or_expression(std::string_view key, const Value&, const Value& whole,
                                             const Expected&, const Units&, const KnownParameters&,
                                             Mistakes&);

class QuantityReader {
 public:
  QuantityReader(const Units& units, KnownParameters known) : units_(units), known_(std::move(known)) {}

  /// "10 um", a plain number where the unit is "1", or an expression. Empty after adding mistakes.
  /// Expressions are remembered: the next job only values them.
  std::optional<double> read(std::string_view key, const Value&, const Expected&, const ValueOf&, Mistakes&);

 private:
  const Units& units_;
  KnownParameters known_;
  std::map<std::pair<std::string, std::string>, Expression> read_;  ///< by text and unit
};

}  // namespace mpmstudy
