#pragma once
/// What accuracy costs: every problem of known answer, run by every scheme on a ladder of cells.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "libmpm/simulation.hpp"

namespace mpmstudy {

/// A number that a scene measures, and what it should be.
struct AccuracyProblem {
  std::string name;  ///< e.g. "weak-collapse"
  std::string what;  ///< the number, e.g. "collapsibility"
  mpm::Scene scene;  ///< with its default numerics; the cell size is the coarsest of the ladder
  int cells = 4;     ///< rungs of the ladder, each half the cell of the one before
  /// The number of a run; NaN if the run has none.
  std::function<double(const mpm::RunResult&)> value;
  /// The exact number; empty where there is none: then the finest runs, extrapolated, stand for it.
  std::function<double()> exact;
};
std::vector<AccuracyProblem> accuracy_problems();

/// One way to compute a scene.
struct AccuracyScheme {
  std::string shape;  ///< `scheme` of the parameter table
  int particles_per_cell = 0;
  std::string transfer = "flip", precision = "double";  ///< as in the parameter table
  bool is_default = false;                              ///< of the problem's kind of scene

  /// "bspline2, 4 per cell, apic, float"; what most schemes are is left out.
  std::string label() const;
  bool operator==(const AccuracyScheme&) const = default;
};

struct AccuracyRow {
  std::string problem, what;
  AccuracyScheme scheme;
  double cell_size = 0;        ///< [m]
  double value = 0;            ///< NaN if the run failed or measured nothing
  double reference = 0;        ///< what it should be
  double reference_error = 0;  ///< half width of its interval; 0 where it is exact
  double error = 0;            ///< |value / reference - 1|
  double cpu_s = 0;
  bool on_front = false;       ///< no other row of the problem is both cheaper and nearer
  std::string problem_of_run;  ///< why there is no value; empty if there is one
};

struct AccuracyBenchOptions {
  std::vector<std::string> problems;  ///< names; empty: all
  int skip_finest = 0;                ///< rungs to leave out at the fine end, for a quick look
  unsigned workers = 1;
  /// Told after each run, by any of the threads, one at a time; may be empty.
  std::function<void(std::size_t done, std::size_t all)> progress;
};

/// Rows by problem, scheme, cell, in this order. The finest cells are for the schemes of the fast step alone:
/// a rung is eight times the work of the one before. Throws std::invalid_argument for a name that is not a
/// problem's.
std::vector<AccuracyRow> bench_accuracy(const AccuracyBenchOptions&);

}  // namespace mpmstudy
