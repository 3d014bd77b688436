#include "runner/study/document.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include "runner/study/characters.hpp"
#include "runner/study/decimal.hpp"
#include "runner/study/moved.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {
namespace {

Place place_of(const toml::source_region& region, const std::string& file) {
  return {file, static_cast<std::uint32_t>(region.begin.line),
          static_cast<std::uint32_t>(region.begin.column)};
}

Table to_table(const toml::table& from, const std::string& file);

Value to_value(const toml::node& node, const std::string& file) {
  Value value{place_of(node.source(), file), {}};
  if (const auto* boolean = node.as_boolean()) value.data = boolean->get();
  if (const auto* integer = node.as_integer()) value.data = integer->get();
  if (const auto* number = node.as_floating_point()) value.data = number->get();
  if (const auto* text = node.as_string()) value.data = text->get();
  if (const auto* array = node.as_array()) {
    List list;
    for (const auto& element : *array) list.push_back(to_value(element, file));
    value.data = std::move(list);
  }
  if (const auto* table = node.as_table()) value.data = to_table(*table, file);
  return value;
}

Table to_table(const toml::table& from, const std::string& file) {
  Table table;
  for (const auto& [key, node] : from)
    table.entries.push_back({std::string(key.str()), place_of(key.source(), file), to_value(node, file)});
  std::stable_sort(table.entries.begin(), table.entries.end(), [](const Entry& a, const Entry& b) {
    return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
  });
  return table;
}

void move_to(Value& value, const Place& place) {
  value.place = place;
  if (auto* list = std::get_if<List>(&value.data))
    for (Value& element : *list) move_to(element, place);
  if (auto* table = std::get_if<Table>(&value.data))
    for (Entry& entry : table->entries) {
      entry.place = place;
      move_to(entry.value, place);
    }
}

/// "there is studies/examples/smoke.toml"; without a file of this name, what to do.
std::string where_it_may_be(const std::filesystem::path& path) {
  std::string text;
  for (const auto& file : same_name_below(path)) text += (text.empty() ? "there is " : ", ") + file.string();
  return text.empty() ? "give the path of a study file" : text;
}

std::string file_text(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  const std::string name = path.string();
  if (!std::filesystem::exists(status)) throw StudyError(name + ": no such file; " + where_it_may_be(path));
  if (std::filesystem::is_directory(status))
    throw StudyError(name + ": is a directory; give the path of a study file (*.toml)");
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (!stream.eof() && !stream) throw StudyError(name + ": cannot be read; check its permissions");
  return text.str();
}

/// The parser's words, without "Error while parsing ...:", and what to do.
std::string not_toml(const toml::parse_error& error) {
  std::string text(error.description());
  if (text.starts_with("Error while parsing"))
    if (const auto colon = text.find(": "); colon != std::string::npos) text.erase(0, colon + 2);
  if (text.starts_with("cannot redefine"))
    return "duplicate key: " + text + "; give every key and table once";
  return "not TOML: " + text + "; strings stand in quotes, see studies/README.md";
}

}  // namespace

std::string Place::text() const {
  if (line == 0) return file;
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

const Entry* Table::find(std::string_view key) const {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

const Table* Table::find_table(std::string_view key) const {
  const Entry* entry = find(key);
  return entry ? entry->value.table() : nullptr;
}

const std::vector<Entry>& entries_of(const Table* table) {
  static const std::vector<Entry> none;
  return table ? table->entries : none;
}

Entry* Table::find(std::string_view key) { return const_cast<Entry*>(std::as_const(*this).find(key)); }

std::string Value::number_text() const {
  if (const auto* integer = std::get_if<std::int64_t>(&data)) return std::to_string(*integer);
  if (const auto* number = std::get_if<double>(&data)) return shortest_text(*number);
  return {};
}

std::string Value::written() const {
  std::string text;
  if (is_number()) {
    text = number_text();
  } else if (const auto* boolean = std::get_if<bool>(&data)) {
    text = *boolean ? "true" : "false";
  } else if (const auto* word = string()) {
    text = "\"" + *word + "\"";
  } else if (const auto* elements = list()) {
    for (const Value& element : *elements) text += (text.empty() ? "" : ", ") + element.written();
    text = "[" + text + "]";
  } else if (const auto* fields = table()) {
    for (const Entry& e : fields->entries)
      text += (text.empty() ? "" : ", ") + e.key + " = " + e.value.written();
    text = text.empty() ? "{}" : "{ " + text + " }";
  } else {
    text = "(a date or a time)";
  }
  text = printable(text);
  constexpr std::size_t longest = 80;
  if (text.size() <= longest) return text;
  std::size_t end = longest - 3;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // not within a character
  return text.substr(0, end) + "...";
}

Table read_document(const std::filesystem::path& path) {
  const std::string text = file_text(path);
  const std::string file = path.string();
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw StudyError(file + ":1:1: the file is empty; a study begins with schema = 1, see studies/README.md");
  try {
    return to_table(toml::parse(text, file), file);
  } catch (const toml::parse_error& error) {
    throw StudyError(place_of(error.source(), file).text() + ": " + not_toml(error));
  }
}

Value read_value(std::string_view key, std::string_view text) {
  const Place place{"--set", 0, 0};
  try {
    Table table = to_table(toml::parse("v = " + std::string(text)), "");
    if (table.entries.size() == 1 && text.find('\n') == std::string_view::npos) {
      move_to(table.entries[0].value, place);
      return std::move(table.entries[0].value);
    }
  } catch (const toml::parse_error& error) {
    const bool is_toml = text.starts_with('[') || text.starts_with('{') || text.starts_with('"');
    if (is_toml)
      throw StudyError("--set: " + std::string(key) + " = " + std::string(text) + ": " + not_toml(error));
  }
  return {place, std::string(text)};
}

}  // namespace mpmstudy
