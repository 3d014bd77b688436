#pragma once
/// What a study's [search] looks for: the quantity, its steps, and the names of what is found.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// The quantity that a study's [search] looks for.
class Searched {
 public:
  explicit Searched(const Study&);

  const mpm::Quantity& quantity() const { return *quantity_; }
  /// Gives it another value. What the file gives by a derived row stays what the file says: with a
  /// wall_thickness, the cavity's centre moves as its radius does.
  void set(mpm::Scene&, double value) const;

 private:
  const mpm::Quantity* quantity_;
  std::vector<const mpm::Quantity*> kept_;
};

/// A search of more steps most likely has a wrong unit: no two runs that are so close differ by more than
/// chance.
constexpr double most_search_steps = 100'000;

/// How many steps of at most `tolerance` go from lower to upper, lower < upper; as a double, because they
/// need not fit into an int.
inline double search_steps(double lower, double upper, double tolerance) {
  return std::max(1.0, std::ceil((upper - lower) / tolerance - 1e-9));
}

/// What a [search] finds, as fits and figures ask for it: "critical_yield_stress" is the middle of the
/// bracket on one cell, "critical_yield_stress_extrapolated" the value for cells of size 0. A speed is
/// "critical_speed" and "critical_speed_extrapolated" as well.
enum class CriticalResult { bracket, extrapolated };

/// Every name that a search for `quantity` has.
std::vector<std::string> critical_names(std::string_view quantity);

/// Empty if the name is none of those of a search for `quantity`; "": of a search for any quantity.
std::optional<CriticalResult> critical_result(std::string_view name, std::string_view quantity = "");

/// Whether two names say the same result of one study.
bool same_result(std::string_view, std::string_view);

}  // namespace mpmstudy
