#pragma once
/// Parameters of a study's own: names in [parameters] that stand in its expressions, and rows of the
/// parameter table that are written as expressions.
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/document.hpp"
#include "runner/study/quantity_reader.hpp"

namespace mpmstudy {

class OwnParameters {
 public:
  /// Reads nothing but names. Keeps references. A row of the table that this kind of scene has not is a
  /// name like any other.
  OwnParameters(const Table& document, std::optional<mpm::SceneKind>, const Units&);

  /// Whether `name` in [parameters] is one of the study's own: no row of the table, and some expression of
  /// the file has it.
  bool has(std::string_view name) const { return own_.contains(std::string(name)); }
  /// A row for it, as if it stood in the table: with its unit in SI. Null after adding mistakes. `has(name)`.
  const mpm::Quantity* row(const Entry&, Mistakes&);
  /// Whether a value is an expression of the study's parameters, and no number with a unit.
  bool is_expression(const Value&, const Expected&) const;
  KnownParameters known(Mistakes&);

 private:
  std::optional<Dimension> dimension(std::string_view name, Mistakes&);
  std::optional<std::string> unit(const Entry&, Mistakes&);
  const Entry* find(std::string_view name) const;

  struct Row {
    std::string name, unit, column;
    mpm::Quantity row{};
  };
  const Table& document_;
  const Units& units_;
  std::set<std::string> own_;
  std::vector<std::string> names_;  ///< that expressions may have
  std::deque<Row> rows_;            ///< in place: axes point to them
  std::vector<std::string> asked_;  ///< whose dimension is being looked for, to see cycles
};

}  // namespace mpmstudy
