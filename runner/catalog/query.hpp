#pragma once
/// SQL that can only read. Three locks, each enough alone: the file is opened read-only; SQLite's defensive
/// mode is on and extensions are off; an authorizer refuses every action but reading.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace mpmstudy {

/// null, integer, real, text; a blob comes as text of hexadecimal digits.
using SqlValue = std::variant<std::monostate, std::int64_t, double, std::string>;

/// "" for what is no text.
std::string text_of(const SqlValue&);
/// Empty for what is no number.
std::optional<double> number_of(const SqlValue&);

/// Takes rows as they come.
class RowSink {
 public:
  virtual ~RowSink() = default;
  virtual void columns(std::span<const std::string> names) = 0;
  virtual void row(std::span<const SqlValue>) = 0;
  virtual void end() {}
};

/// Rows that are kept.
struct Rows : RowSink {
  std::vector<std::string> names;
  std::vector<std::vector<SqlValue>> rows;

  void columns(std::span<const std::string> given) override { names.assign(given.begin(), given.end()); }
  void row(std::span<const SqlValue> given) override { rows.emplace_back(given.begin(), given.end()); }
  /// Position of a column; throws CatalogError if there is none.
  std::size_t column(const std::string& name) const;
};

/// One statement over a catalog, in one consistent view of it. `parameters` take the places of ?1, ?2, ...
/// Throws CatalogError: no catalog, an error in the SQL, more than one statement, anything that would write,
/// a text of more than 16 MB, more than most_seconds (0: no limit).
void query(const std::filesystem::path& results, const std::string& sql, RowSink&,
           std::span<const SqlValue> parameters = {}, double most_seconds = 0);
Rows query(const std::filesystem::path& results, const std::string& sql,
           std::span<const SqlValue> parameters = {});

}  // namespace mpmstudy
