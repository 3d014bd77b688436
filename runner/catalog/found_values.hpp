#pragma once
/// What searches and fits of a study have found. Each call opens the catalog read-only; all throw
/// CatalogError.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"

namespace mpmstudy {

/// Brackets of a search in the order of the sweep, their ends with all digits: keys are made of them. Cell
/// size, runs and what is swept are left out.
std::vector<BracketRow> brackets_of(const std::filesystem::path& results, const std::string& study,
                                    const std::string& quantity);

/// A row of the view `critical_speed`. Speeds in m/s.
struct CriticalSpeed {
  double wall_thickness = 0;  ///< [m]
  double cell_size = 0;       ///< [m]
  std::optional<double> lower, upper, extrapolated, interval;
  std::string flags;
  bool proven = false;              ///< the job at the upper end is one of the study's
  std::optional<double> parameter;  ///< of that job
};
/// Those with a wall thickness, by it. `parameter`: whose value is wanted of the job at the upper end.
std::vector<CriticalSpeed> critical_speeds(const std::filesystem::path& results, const std::string& study,
                                           const std::string& parameter);

/// Coefficients of the curves through a quantity, without covariance and text.
std::vector<FitRow> fits_of(const std::filesystem::path& results, const std::string& study,
                            const std::string& quantity);

}  // namespace mpmstudy
