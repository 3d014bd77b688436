#pragma once
/// The one list of every number that a job can come to (what a search finds out of many is no such number).
/// Study files, ladders, intervals and the tests of the catalog's page are made from it: a new number is
/// measured in libmpm/measure/ and has one row here. Checked by tests/runner/study/result_names_test.cpp,
/// which runs every kind of scene.
#include <limits>
#include <span>
#include <string_view>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// What a job has to ask for, beside the right kind of scene, to show a result.
enum class Needs {
  nothing,
  ejection,  ///< decides = "ejection"
};

/// One number of a job.
struct ResultRow {
  std::string_view name;     ///< in study files and in the catalog, with its unit: "stop_radius_m"
  std::string_view unit;     ///< SI as in the catalog ("m2"); "1" for a pure number
  std::string_view symbol;   ///< for figures, or ""
  std::string_view meaning;  ///< one line
  bool (*belongs_to)(SceneKind);
  Needs needs = Needs::nothing;
  /// Whether cells of several sizes give it an interval. Not: what a run is given, what it costs, extremes of
  /// its health, and what is an error itself.
  bool has_interval = true;
  /// What it can be at all, in its unit.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  /// What an accuracy is relative to: the absolute value, but no less than this.
  double least_scale = 0;
};

/// In the order of the catalog's page.
std::span<const ResultRow> results();
const ResultRow* find_result(std::string_view name);  ///< null if there is none

/// What RunResult::outcome can say, beside "undecided". None: the kind of scene decides nothing.
std::span<const std::string_view> outcomes_of(SceneKind);

}  // namespace mpm
