#include "runner/cli/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "runner/status/label.hpp"
#include "runner/study/characters.hpp"

namespace mpmstudy {
namespace {

constexpr std::string_view gap = "  ";

std::size_t width_of(const TextColumn& column) {
  std::size_t width = std::max(characters_in(column.name), characters_in(column.unit));
  for (const auto& cell : column.cells) width = std::max(width, characters_in(cell));
  return width;
}

}  // namespace

std::size_t table_columns(const std::vector<TextColumn>& columns) {
  std::size_t sum = 0;
  for (const auto& column : columns) sum += gap.size() + width_of(column);
  return sum;
}

std::string text_table(const std::vector<TextColumn>& columns) {
  std::vector<std::size_t> widths;
  for (const auto& column : columns) widths.push_back(width_of(column));
  std::string text;
  const auto line = [&](auto cell_of) {
    std::string one;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string cell = cell_of(columns[i]);
      const std::string blanks(widths[i] - characters_in(cell), ' ');
      one += gap;
      one += columns[i].left ? cell + blanks : blanks + cell;
    }
    one.erase(one.find_last_not_of(' ') + 1);
    text += cut_text(one, line_columns) + "\n";
  };
  line([](const TextColumn& column) { return column.name; });
  if (std::ranges::any_of(columns, [](const auto& column) { return !column.unit.empty(); }))
    line([](const TextColumn& column) { return column.unit; });
  const std::size_t rows = columns.empty() ? 0 : columns[0].cells.size();
  for (std::size_t row = 0; row < rows; ++row)
    line([&](const TextColumn& column) { return column.cells.at(row); });
  return text;
}

std::vector<std::string> distinct_texts(const std::vector<double>& numbers) {
  constexpr int fewest = 6, most = 10;
  const auto with_digits = [&](int digits) {
    std::vector<std::string> texts;
    for (const double number : numbers) texts.push_back(fmt::format("{:.{}g}", number, digits));
    return texts;
  };
  const auto different = [](const std::vector<std::string>& texts) {
    return std::set<std::string>(texts.begin(), texts.end()).size();
  };
  const std::size_t wanted = different(with_digits(most));
  int digits = fewest;
  while (digits < most && different(with_digits(digits)) < wanted) ++digits;
  return with_digits(digits);
}

}  // namespace mpmstudy
