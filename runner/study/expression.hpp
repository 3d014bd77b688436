#pragma once
/// Quantities that a study writes as an expression of others: "block_height - wall - cavity_radius", "2 *
/// radius
/// + 0.1 um". Read by muParser, which nothing else includes.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runner/study/dimension.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// How numbers are compared. to_12_digits: two that agree so far are equal, so that 1.2 um is not more than 1
/// um + 0.2 um, whatever rounding makes of the sum.
enum class Comparison { exact, to_12_digits };

/// Why a text is no expression.
struct ExpressionRefusal : Refusal {
  std::size_t at = 0;  ///< where in the text, in characters from 0
};

class Expression {
 public:
  /// What a name stands for. Empty: there is no such parameter.
  using DimensionOf = std::function<std::optional<Dimension>(std::string_view name)>;

  /// `names`: all that may be used, for messages. Numbers may have units: they become SI.
  static std::variant<Expression, ExpressionRefusal> read(std::string_view text, const Units&,
                                                          const DimensionOf&,
                                                          const std::vector<std::string>& names,
                                                          Comparison = Comparison::exact);

  /// The parameters that it is made of, each once.
  const std::vector<std::string>& names() const;
  /// Of its value. Found by counting in other base units, one after the other.
  const Dimension& dimension() const;
  /// Whether its value has that dimension; 0 has every one.
  bool has(const Dimension&) const;
  /// In SI, of the parameters in SI. Not finite where it has no value: a division by zero, a root of less
  /// than nothing.
  double value(const std::function<double(const std::string& name)>& of) const;

 private:
  struct Parsed;
  explicit Expression(std::shared_ptr<Parsed> parsed) : parsed_(std::move(parsed)) {}
  std::shared_ptr<Parsed> parsed_;
};

/// The names in a text that would be parameters of an expression: words that follow no number and are no
/// functions.
std::vector<std::string> names_in(std::string_view text);

}  // namespace mpmstudy
