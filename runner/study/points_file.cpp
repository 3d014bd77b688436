#include "runner/study/points_file.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <utility>

#include "runner/study/characters.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

struct Cell {
  std::string text;
  Place place;
};

/// The cells of one line. Empty after adding a mistake: a quote that is not closed.
std::vector<Cell> cells_of(std::string_view line, const Place& begin, Mistakes& mistakes) {
  std::vector<Cell> cells;
  std::size_t at = 0;
  for (;;) {
    Cell cell{"", begin};
    const std::size_t from = std::min(line.find_first_not_of(" \t", at), line.size());
    cell.place.column = 1 + static_cast<std::uint32_t>(characters_in(line.substr(0, from)));
    if (from < line.size() && line[from] == '"') {
      for (at = from + 1; at < line.size(); ++at) {
        if (line[at] != '"')
          cell.text += line[at];
        else if (at + 1 < line.size() && line[at + 1] == '"')
          cell.text += line[at++];
        else
          break;
      }
      if (at >= line.size()) {
        mistakes.add(cell.place, "points", "\"" + cell.text,
                     {"a quote that is not closed", "write the second \" on the same line"});
        return {};
      }
      at = line.find(',', at);
    } else {
      at = line.find(',', at);
      cell.text = trimmed(line.substr(from, at == line.npos ? at : at - std::min(from, at)));
    }
    cells.push_back(std::move(cell));
    if (at == line.npos) return cells;
    ++at;
  }
}

/// A number as it stands in a file of numbers; as text what is none.
Value value_of(const Cell& cell) {
  const char *const begin = cell.text.data(), *const end = begin + cell.text.size();
  std::int64_t whole = 0;
  if (const auto read = std::from_chars(begin, end, whole); read.ec == std::errc() && read.ptr == end)
    return {cell.place, whole};
  double number = 0;
  if (const auto read = std::from_chars(begin, end, number); read.ec == std::errc() && read.ptr == end)
    return {cell.place, number};
  return {cell.place, cell.text};
}

bool is_name(std::string_view text) {
  return !text.empty() && !(text[0] >= '0' && text[0] <= '9') && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// "impact_speed [m/s]". Empty after adding a mistake.
std::optional<PointColumn> column_of(const Cell& header, Mistakes& mistakes) {
  PointColumn column{header.text, {}, header.place, {}};
  if (const auto open = header.text.find('['); open != std::string::npos && header.text.ends_with(']')) {
    column.name = trimmed(std::string_view(header.text).substr(0, open));
    column.unit = trimmed(std::string_view(header.text).substr(open + 1, header.text.size() - open - 2));
  }
  if (is_name(column.name)) return column;
  mistakes.add(header.place, "points", "\"" + header.text + "\"",
               {header.text.empty() ? "a column without a name" : "not the name of a parameter",
                "the first line of the file names parameters, such as impact_speed [m/s], material"});
  return std::nullopt;
}

/// The columns with all their values; mistakes are added.
std::vector<PointColumn> read_columns(const std::string& text, const std::string& file, Mistakes& mistakes) {
  std::vector<PointColumn> columns;
  std::istringstream lines(text);
  Place place{file, 0, 1};
  int wrong_lines = 0;
  constexpr int most_wrong_lines = 20;  // more would tell nothing new
  for (std::string line; wrong_lines < most_wrong_lines && std::getline(lines, line);) {
    ++place.line;
    if (place.line == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // as spreadsheets begin files
    if (line.ends_with('\r')) line.pop_back();
    if (trimmed(line).empty()) continue;
    const std::vector<Cell> cells = cells_of(line, place, mistakes);
    if (columns.empty()) {
      for (const Cell& header : cells)
        if (auto column = column_of(header, mistakes)) columns.push_back(std::move(*column));
      if (columns.size() != cells.size() || columns.empty()) return {};
    } else if (cells.size() != columns.size()) {
      ++wrong_lines;
      if (!cells.empty())
        mistakes.add(
            cells.back().place, "points", "\"" + cells.back().text + "\"",
            {"the line has " + std::to_string(cells.size()) + " values",
             "allowed: " + std::to_string(columns.size()) + ", as many as the first line has names"});
    } else {
      bool good = true;
      for (std::size_t k = 0; k < cells.size(); ++k) {
        Value value = value_of(cells[k]);
        if (cells[k].text.empty() || (columns[k].unit && !value.is_number())) {
          good = false;
          mistakes.add(
              columns[k].name, value,
              {cells[k].text.empty() ? "no value" : "not a number",
               columns[k].unit ? "allowed: a number, in " + *columns[k].unit + " as the first line says"
                               : "every line needs one"});
        }
        columns[k].values.push_back(std::move(value));
      }
      wrong_lines += !good;
    }
  }
  return columns;
}

/// The table that a parameter of this name is written in.
std::string home_of(std::string_view name) {
  const bool is_row = mpm::find_quantity(name) || mpm::find_choice(name);
  return is_row ? std::string(table_of(name).value_or("parameters")) : "parameters";
}

bool is_set(const Table& table, std::string_view name) {
  const Entry* entry = table.find(name);
  return entry && entry->place.line == 0;
}

/// One column as an entry of its table.
void add_column(Table& document, PointColumn column, Mistakes& mistakes) {
  const std::string home = home_of(column.name);
  if (!home.empty() && !document.find(home))
    document.entries.push_back({home, column.place, {column.place, Table{}}});
  Table* table = home.empty() ? &document : std::get_if<Table>(&document.find(home)->value.data);
  if (!table) return;  // said where tables are read
  const mpm::Quantity* row = mpm::find_quantity(column.name);
  if (is_set(*table, column.name) || (row && is_set(*table, row->alternative))) return;
  if (const Entry* other = table->find(column.name)) {
    mistakes.add(column.place, column.name,
                 {"given twice, also at " + other->place.text(), "give it in one place"});
    return;
  }
  Value value{column.place, std::move(column.values)};
  if (column.unit)
    value = {column.place, Table{{{"values", column.place, std::move(value)},
                                  {"unit", column.place, {column.place, *column.unit}}}}};
  table->entries.push_back({column.name, column.place, std::move(value)});
}

}  // namespace

std::optional<std::vector<PointColumn>> read_point_columns(const std::filesystem::path& file,
                                                           Mistakes& mistakes) {
  std::error_code ignored;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, ignored)) return std::nullopt;
  std::ostringstream text;
  text << stream.rdbuf();
  return read_columns(text.str(), file.string(), mistakes);
}

std::optional<ZipGroup> add_points(Table& document, const std::filesystem::path& study, Mistakes& mistakes) {
  const Table* sweep = document.find_table("sweep");
  const Entry* entry = sweep ? sweep->find("points") : nullptr;
  if (!entry) return std::nullopt;
  const Value points = entry->value;  // the document will grow
  const auto refuse = [&](const Refusal& refusal) {
    mistakes.add("points", points, refusal);
    return std::nullopt;
  };
  if (!points.string() || points.string()->empty())
    return refuse(
        {"not a file", "allowed: the path of a CSV file beside the study file, such as \"doe.csv\""});
  if (const Entry* mode = sweep->find("mode");
      mode && mode->value.string() && *mode->value.string() != "grid")
    return refuse({"does not go with mode " + mode->value.written(), "remove one of the two"});
  const std::filesystem::path named = *points.string();
  if (std::ranges::find(named, "..") != named.end())
    return refuse({"leads out of the folder of the study file",
                   "allowed: a path from that folder without \"..\", or from /"});
  const std::filesystem::path file = study.parent_path() / *points.string();
  const std::size_t before = mistakes.size();
  auto read = read_point_columns(file, mistakes);
  if (!read)
    return refuse(
        {"cannot be read", "allowed: a CSV file; its path begins at the folder of the study file, " +
                               file.string() + " is looked for"});
  std::vector<PointColumn>& columns = *read;
  if (mistakes.size() > before) return std::nullopt;
  if (columns.empty() || columns.front().values.empty())
    return refuse(
        {file.string() + " has no points",
         "its first line names parameters, such as impact_speed [m/s], every other line is a point"});
  ZipGroup group{{}, points.place, "points", points.written(), true};
  for (PointColumn& column : columns) {
    if (std::ranges::find(group.names, column.name) != group.names.end()) {
      mistakes.add(column.place, column.name, {"has two columns", "allowed: one"});
      continue;
    }
    group.names.push_back(column.name);
    add_column(document, std::move(column), mistakes);
  }
  return group;
}

}  // namespace mpmstudy
