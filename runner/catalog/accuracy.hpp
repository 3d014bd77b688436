#pragma once
/// Intervals from several cells, and the cells that they are made from. Each call opens the catalog
/// read-only; all throw CatalogError.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mpmstudy {

/// What one cell under a job gives of one quantity; a row of the view `ladders` that is done.
struct LadderValue {
  std::string key;       ///< of the job
  std::string rung_key;  ///< of the job with this cell
  double cell_size = 0;  ///< [m]
  std::string quantity;
  double value = 0;
  std::string unit;
  std::optional<double> measuring_error;
};
/// Of a study: of one quantity, or of all ("").
std::vector<LadderValue> ladder_values(const std::filesystem::path& results, const std::string& study,
                                       const std::string& quantity = "");

/// Whether a job of a study has reached the accuracy that is wanted.
struct JobAccuracy {
  std::string key;
  bool reached = false;  ///< false, too, where the quantity has no interval
};
/// In the order of the sweep.
std::vector<JobAccuracy> accuracies(const std::filesystem::path& results, const std::string& study,
                                    const std::string& quantity);

/// The largest half width of a study's intervals of a quantity, as a share of its value; empty: none.
std::optional<double> largest_relative_error(const std::filesystem::path& results, const std::string& study,
                                             const std::string& quantity);

/// Studies with an accuracy that was not reached or a point of a search without a bracket.
std::vector<std::string> studies_that_missed(const std::filesystem::path& results);

}  // namespace mpmstudy
