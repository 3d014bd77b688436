#pragma once
/// The one table of every number that a job can come to (what a search finds out of many is no such number).
/// Study files, ladders, intervals, figures, SQL and the catalog's page are made from it. A measurement has
/// its rows in its own file, beside the code that measures; kinds of scene name their measurements
/// (kinds/kind.hpp). Checked by tests/runner/study/result_names_test.cpp, which runs every kind of scene.
#include <array>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "libmpm/result.hpp"
#include "libmpm/scene/parameters.hpp"

namespace mpm {

/// What a job has to ask for, beside the right kind of scene, to show a result.
enum class Needs {
  nothing,
  ejection,  ///< decides = "ejection"
};

/// Spaces that have a result; all of them, where nothing is said.
struct SpaceSet {
  unsigned bits = ~0u;
  constexpr SpaceSet() = default;
  constexpr SpaceSet(std::initializer_list<Space> spaces) : bits(0) {
    for (const Space space : spaces) bits |= 1u << static_cast<unsigned>(space);
  }
  constexpr bool operator()(Space space) const { return (bits >> static_cast<unsigned>(space)) & 1u; }
};

/// One number of a job.
struct ResultRow {
  std::string_view name;         ///< in study files and in the catalog, with its unit: "stop_radius_m"
  std::string_view unit;         ///< SI as in the catalog ("m2"); "1" for a pure number
  std::string_view symbol = "";  ///< for figures
  std::string_view title = "";   ///< in figures, where it is not the name in words
  std::string_view meaning;      ///< one line, for people: it stands on the catalog's page
  /// Whether cells of several sizes give it an interval. Not: what a run is given, what it costs, extremes of
  /// its health, and what is an error itself.
  bool has_interval = true;
  /// What it can be at all, in its unit.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  /// What an accuracy is relative to: the absolute value, but no less than this.
  double least_scale = 0;
  Needs needs = Needs::nothing;
  SpaceSet spaces = {};
  bool always = true;                  ///< false: some runs do not show it, as an event that did not happen
  bool metric = true;                  ///< whether it is one of RunResult::metrics, and in the view `metrics`
  bool column = false;                 ///< whether it is a column of the view `jobs`
  std::string_view error_column = "";  ///< of the view `jobs`, that has its interval
  /// Results that are the two parts of its measuring error, which are added in quadrature: how far two
  /// measurements of it differ, and how it scatters in time.
  std::string_view difference = "", scatter = "";
  /// It is 1 - final / initial of one of these: of the first that the job has.
  std::array<std::string_view, 2> lost_share_of = {};
  /// Means nothing where the view `jobs` has `flags`: the cavity is no closed hole at the end.
  bool of_closed_cavity = false;
  KindSet belongs_to = {};  ///< filled in by results()
};

/// The rows of one measurement.
using Results = std::span<const ResultRow> (*)();

/// The row of that name; a name that no row has does not compile.
consteval const ResultRow& row_of(std::span<const ResultRow> rows, std::string_view name) {
  for (const ResultRow& row : rows)
    if (row.name == name) return row;
  throw "no row of the table has this name";
}
/// What a run came to; its interval, where one is known.
inline Metric metric(const ResultRow& row, double value, std::optional<double> error = {}) {
  return {std::string(row.name), value, std::string(row.unit), error};
}

/// In the order of the catalog's page.
std::span<const ResultRow> results();
const ResultRow* find_result(std::string_view name);  ///< null if there is none

}  // namespace mpm
