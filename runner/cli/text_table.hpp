#pragma once
#include <string>
#include <vector>

namespace mpmstudy {

/// A column of a table for a terminal: one or two lines of head, then its cells.
struct TextColumn {
  std::string name, unit;  ///< "cavity_radius", "um"; the line of units is left out where no column has one
  std::vector<std::string> cells;
  bool left = false;  ///< texts stand left, numbers right
};

/// Lines "  a  b", each ended by a line feed and cut at line_columns. Columns have equally many cells.
std::string text_table(const std::vector<TextColumn>&);
/// Columns that its lines take.
std::size_t table_columns(const std::vector<TextColumn>&);

/// Numbers with six significant digits, or with as many up to ten as tell those apart that differ in ten.
/// What differs by rounding only stays alike.
std::vector<std::string> distinct_texts(const std::vector<double>&);

}  // namespace mpmstudy
