#include "runner/catalog/query.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <string_view>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/schema.hpp"

namespace mpmstudy {
namespace {

constexpr std::array<std::string_view, 4> readable_pragmas = {"table_info", "table_xinfo", "table_list",
                                                              "function_list"};
constexpr std::array<std::string_view, 3> refused_functions = {"load_extension", "fts3_tokenizer",
                                                               "sqlite_compileoption_get"};

constexpr int largest_value = 16 << 20;  ///< of a text or a blob [bytes]
constexpr int longest_pattern = 500;     ///< of LIKE and GLOB: how long they take grows with it
constexpr int operations_between_looks = 10'000;

bool contains(auto& words, const char* word) {
  return word != nullptr && std::ranges::any_of(words, [&](std::string_view w) {
           return std::ranges::equal(w, std::string_view(word), [](char a, char b) {
             return a == std::tolower(static_cast<unsigned char>(b));
           });
         });
}

int allow_reading(void*, int action, const char* first, const char* second, const char*, const char*) {
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_READ:
    case SQLITE_RECURSIVE:
      return SQLITE_OK;
    case SQLITE_FUNCTION:
      return contains(refused_functions, second) ? SQLITE_DENY : SQLITE_OK;
    case SQLITE_PRAGMA:
      return contains(readable_pragmas, first) ? SQLITE_OK : SQLITE_DENY;
    default:
      return SQLITE_DENY;
  }
}

void lock_down(SQLite::Database& db) {
  sqlite3* handle = db.getHandle();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 0);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, largest_value);
  sqlite3_limit(handle, SQLITE_LIMIT_LIKE_PATTERN_LENGTH, longest_pattern);
  sqlite3_set_authorizer(handle, allow_reading, nullptr);
}

/// Finalized when it is destroyed.
struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Prepared = std::unique_ptr<sqlite3_stmt, Finalize>;

/// Interrupts a statement that goes on for too long.
class TimeLimit {
 public:
  TimeLimit(sqlite3* handle, double seconds)
      : end_(Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {
    if (seconds > 0) sqlite3_progress_handler(handle, operations_between_looks, is_over, this);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static int is_over(void* self) { return Clock::now() > static_cast<TimeLimit*>(self)->end_; }
  Clock::time_point end_;
};

/// What is not there may be there after an update.
std::string older_note(sqlite3* handle) {
  sqlite3_set_authorizer(handle, nullptr, nullptr);  // the connection is not used again
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(handle, "PRAGMA user_version", -1, &raw, nullptr);
  const Prepared version(raw);
  if (!version || sqlite3_step(version.get()) != SQLITE_ROW ||
      sqlite3_column_int(version.get(), 0) >= current_catalog_schema().version())
    return "";
  return "; the catalog is of an older mpmstudy, `mpmstudy run STUDY` brings it up to date";
}

[[noreturn]] void refuse(sqlite3* handle, int code) {
  if (code == SQLITE_INTERRUPT) throw CatalogError("query: it took too long");
  if (code == SQLITE_AUTH)
    throw CatalogError("query: " + std::string(sqlite3_errmsg(handle)) +
                       ": only reading is allowed (SELECT over the views; see runner/catalog/VIEWS.md)");
  const std::string message = sqlite3_errmsg(handle);
  throw CatalogError("query: " + message + older_note(handle));
}

/// Plain SQLite: Statement of SQLiteCpp silently ignores what follows the first statement.
Prepared prepare(sqlite3* handle, const std::string& sql) {
  if (sql.find('\0') != std::string::npos) throw CatalogError("query: the SQL holds a zero byte");
  sqlite3_stmt* raw = nullptr;
  const char* tail = nullptr;
  const int code = sqlite3_prepare_v2(handle, sql.c_str(), -1, &raw, &tail);
  Prepared statement(raw);
  if (code != SQLITE_OK) refuse(handle, code);
  if (!statement) throw CatalogError("query: there is no statement");
  sqlite3_stmt* next = nullptr;
  const int next_code = sqlite3_prepare_v2(handle, tail, -1, &next, nullptr);
  const Prepared second(next);
  if (next_code != SQLITE_OK || second) throw CatalogError("query: only one statement at a time");
  if (sqlite3_stmt_readonly(statement.get()) == 0)
    throw CatalogError("query: only reading is allowed (SELECT over the views; see runner/catalog/VIEWS.md)");
  return statement;
}

void bind(sqlite3_stmt* statement, int i, const SqlValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    sqlite3_bind_int64(statement, i, *integer);
  else if (const auto* real = std::get_if<double>(&value))
    sqlite3_bind_double(statement, i, *real);
  else if (const auto* text = std::get_if<std::string>(&value))
    sqlite3_bind_text(statement, i, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
}

std::string hexadecimal(const unsigned char* bytes, int size) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (int i = 0; i < size; ++i) text += {digits[bytes[i] >> 4], digits[bytes[i] & 15]};
  return text;
}

SqlValue value_of(sqlite3_stmt* s, int i) {
  switch (sqlite3_column_type(s, i)) {
    case SQLITE_INTEGER:
      return static_cast<std::int64_t>(sqlite3_column_int64(s, i));
    case SQLITE_FLOAT:
      return sqlite3_column_double(s, i);
    case SQLITE_TEXT: {
      const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(s, i));
      return std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(s, i)));
    }
    case SQLITE_BLOB: {
      const auto* bytes = static_cast<const unsigned char*>(sqlite3_column_blob(s, i));
      return hexadecimal(bytes, sqlite3_column_bytes(s, i));
    }
    default:
      return std::monostate{};
  }
}

}  // namespace

std::string text_of(const SqlValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text ? *text : "";
}

std::optional<double> number_of(const SqlValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::nullopt;
}

std::size_t Rows::column(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw CatalogError("catalog: there is no column '" + name + "'");
  return static_cast<std::size_t>(found - names.begin());
}

void query(const std::filesystem::path& results, const std::string& sql, RowSink& sink,
           std::span<const SqlValue> parameters, double most_seconds) {
  const auto db = open_for_reading(results);
  lock_down(*db);
  const TimeLimit limit(db->getHandle(), most_seconds);
  const auto statement = prepare(db->getHandle(), sql);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    bind(statement.get(), static_cast<int>(i) + 1, parameters[i]);

  const int count = sqlite3_column_count(statement.get());
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.emplace_back(sqlite3_column_name(statement.get(), i));
  sink.columns(names);
  std::vector<SqlValue> row(names.size());
  int code = SQLITE_ROW;
  while ((code = sqlite3_step(statement.get())) == SQLITE_ROW) {
    for (int i = 0; i < count; ++i) row[static_cast<std::size_t>(i)] = value_of(statement.get(), i);
    sink.row(row);
  }
  if (code != SQLITE_DONE) refuse(db->getHandle(), code);
  sink.end();
}

Rows query(const std::filesystem::path& results, const std::string& sql,
           std::span<const SqlValue> parameters) {
  Rows rows;
  query(results, sql, rows, parameters);
  return rows;
}

}  // namespace mpmstudy
