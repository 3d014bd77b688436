#pragma once
/// The ladder of exact answers: problems whose solution is known, what the library makes of them, and how far
/// off it may be. The tests of tests/verification assert on these numbers; `mpmstudy bench exact` prints
/// them.
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm::verification {

/// How a difference is judged.
enum class Judged {
  relative,  ///< |ours/exact - 1|
  absolute,  ///< |ours - exact|; where the exact number is 0
  shortfall  ///< how much ours is less than the exact number; more is as good
};

/// One number of known answer.
struct ExactNumber {
  std::string quantity;
  std::string unit;  ///< SI; "1" for a pure number
  double exact = 0;
  double ours = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not measured
  double tolerance = 0;                                    ///< of the error
  Judged judged = Judged::relative;
  std::string trouble{};  ///< why the run broke down; empty where it did not

  double error() const;
  bool holds() const { return error() <= tolerance; }
};
using ExactNumbers = std::vector<ExactNumber>;

/// The number of that name. Throws std::out_of_range naming those there are.
const ExactNumber& number_of(const ExactNumbers&, std::string_view quantity);

/// What may be chosen about a run. The tolerances are those of the cells and schemes that it begins with.
struct ExactOptions {
  double cells = 1;                            ///< every cell size times this
  std::optional<mpm::ShapeFunction> scheme{};  ///< empty: the default of the scene
  std::optional<int> particles_per_cell{};     ///< a square number; empty: the default of the scene
};

struct ExactProblem {
  std::string name;  ///< "planar-1120"
  std::string what;  ///< one line, for people
  ExactNumbers (*solve)(const ExactOptions&);
};

/// In the order of the ladder: material point, planar waves, shells, elastic bodies, invariances.
std::span<const ExactProblem> exact_problems();

struct ExactRow {
  const ExactProblem* problem;
  ExactNumber number;
  double cpu_s;  ///< of the problem
};

/// The problems of these names (empty: all), each solved once, `workers` at a time; rows in the order of the
/// ladder. Throws std::invalid_argument for a name that is not a problem's, mpm::InputError where the options
/// make a scene that cannot be run.
std::vector<ExactRow> bench_exact(const std::vector<std::string>& names, const ExactOptions&,
                                  unsigned workers = 1);

}  // namespace mpm::verification
