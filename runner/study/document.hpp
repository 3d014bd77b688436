#pragma once
/// A TOML file as plain values that know where they stand: what the rest of the study reader works on.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mpmstudy {

/// Where something was written. line 0: not in a file but on the command line (`file` is then "--set").
struct Place {
  std::string file;
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< from 1, in characters
  std::string text() const;  ///< "studies/a.toml:3:7", "--set"
};

struct Value;
struct Entry;
using List = std::vector<Value>;

/// The entries of a table in the order of the file.
struct Table {
  std::vector<Entry> entries;
  const Entry* find(std::string_view key) const;  ///< null if there is none
  Entry* find(std::string_view key);
  /// The table under that key; null if there is none, or no table.
  const Table* find_table(std::string_view key) const;
};
/// Of a table that may not be there: then none. Nothing is copied.
const std::vector<Entry>& entries_of(const Table*);

/// One TOML value. Dates and times, which no study uses, are monostate.
struct Value {
  Place place;
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Table> data;

  const std::string* string() const { return std::get_if<std::string>(&data); }
  const List* list() const { return std::get_if<List>(&data); }
  const Table* table() const { return std::get_if<Table>(&data); }
  bool is_number() const {
    return std::holds_alternative<std::int64_t>(data) || std::holds_alternative<double>(data);
  }
  std::string number_text() const;  ///< decimal text of a number ("nan", "inf" are possible)
  std::string written() const;      ///< as in the file, shortened where it is long
};

struct Entry {
  std::string key;
  Place place;  ///< of the key
  Value value;
};

/// Reads a file. Throws StudyError: missing, a directory, unreadable, empty, not TOML.
Table read_document(const std::filesystem::path&);

/// One value in TOML syntax, every place of it "--set". Text that is no TOML and does not begin like an
/// array, a table or a string is a string: shells take the quotes of `--set speed="300 m/s"` away.
/// Throws StudyError, with `key` in its text.
Value read_value(std::string_view key, std::string_view text);

}  // namespace mpmstudy
