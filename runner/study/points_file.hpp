#pragma once
/// [sweep] points = "doe.csv": the points of a sweep from a file of comma-separated values beside the study
/// file. Its header names parameters, with the unit of their numbers: impact_speed [m/s]. Columns without a
/// unit hold words, pure numbers, or quantities that bring their own ("200 m/s").
#include <filesystem>
#include <optional>

#include "runner/study/sweep_request.hpp"

namespace mpmstudy {

struct PointColumn {
  std::string name;
  std::optional<std::string> unit;  ///< of its header
  Place place;                      ///< of its header
  List values;                      ///< numbers where it has a unit; as many as other columns have
};
/// The columns of a file; there may be none after adding mistakes. Empty without: it cannot be read.
std::optional<std::vector<PointColumn>> read_point_columns(const std::filesystem::path&, Mistakes&);

/// Puts every column into the document as a list of values of its parameter, and returns which of them go
/// together. A column whose parameter --set has said is left out. Empty: there is no `points`, or after
/// adding mistakes.
std::optional<ZipGroup> add_points(Table& document, const std::filesystem::path& study, Mistakes&);

}  // namespace mpmstudy
