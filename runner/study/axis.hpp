#pragma once
/// What a study says about one parameter: a value, or a sweep of it.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/expression.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// One value on an axis.
struct Point {
  double value = 0;  ///< SI; of a choice: the index of its word
  Place place;       ///< for messages
};

/// How the values of a range are spread.
enum class Spread { even, logarithmic, normal };

/// { from, to, count, unit, spacing }, or a distribution { uniform | log_uniform | normal = [a, b], unit }:
/// kept as it is written, because a count may be absurd.
struct SweepRange {
  double from = 0, to = 0;             ///< in the written unit; of a normal one: mean and standard deviation
  std::string from_text, to_text;      ///< the same exactly
  std::optional<std::uint64_t> count;  ///< sampled modes need none
  Spread spread = Spread::even;
  bool is_distribution = false;  ///< written as one: of a sampled mode only
  Conversion conversion;

  /// The point below which that share of the values lies, 0 <= share <= 1, in SI; all but the ends are
  /// rounded to 12 digits of the written unit.
  double at(double share) const;
};

struct Axis {
  const mpm::Quantity* quantity = nullptr;  ///< one of these two is set
  const mpm::Choice* choice = nullptr;
  Place place;          ///< of the key
  Place value_place;    ///< of the value
  std::string written;  ///< the value, as in the file
  bool swept = false;
  bool own = false;                      ///< a parameter of the study's own: its quantity is in no table
  std::vector<Point> points;             ///< empty if range is set
  std::optional<Expression> expression;  ///< in place of the value of its only point
  std::optional<SweepRange> range;

  std::string_view name() const { return quantity ? quantity->name : choice->name; }
  /// Number of values; 0 for a range without a count.
  std::uint64_t size() const { return range ? range->count.value_or(0) : points.size(); }
  Point point(std::uint64_t i) const;  ///< i < size()
};

/// Reads the value of a row of the parameter table. Empty after adding mistakes.
std::optional<Axis> read_axis(const mpm::Quantity&, const Entry&, const Units&, Mistakes&);
std::optional<Axis> read_axis(const mpm::Choice&, const Entry&, Mistakes&);
/// One whose only value is an expression.
Axis expression_axis(const mpm::Quantity&, const Entry&, Expression);

}  // namespace mpmstudy
