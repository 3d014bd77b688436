#include "runner/paper/reference_claims.hpp"

#include <string_view>
#include <utility>
#include <vector>

#include "runner/paper/reference_claims_csv.hpp"

namespace mpmstudy {
namespace {

/// Rows of RFC 4180: a cell may be quoted, and then hold commas, line ends, and quotes that are doubled.
std::vector<std::vector<std::string>> rows_of_csv(std::string_view text) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string cell;
  bool quoted = false;
  const auto end_cell = [&] { row.push_back(std::exchange(cell, {})); };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c != '"')
        cell += c;
      else if (i + 1 < text.size() && text[i + 1] == '"')
        cell += text[++i];
      else
        quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      end_cell();
    } else if (c == '\n') {
      end_cell();
      rows.push_back(std::exchange(row, {}));
    } else if (c != '\r') {
      cell += c;
    }
  }
  return rows;
}

}  // namespace

const std::map<std::string, ReferenceClaim>& reference_claims() {
  static const auto claims = [] {
    std::map<std::string, ReferenceClaim> all;
    for (const auto& row : rows_of_csv(reference_claims_csv))
      if (row.size() == 4 && row[0] != "name") all[row[0]] = {row[2], row[3]};
    return all;
  }();
  return claims;
}

}  // namespace mpmstudy
