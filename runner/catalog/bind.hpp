#pragma once
/// Values into statements of SQLite; for the .cpp files of the catalog.
#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace mpmstudy {

// bind(statement, 1, a, b, ...): optionals and numbers that are none become null.
inline void bind_one(SQLite::Statement& s, int i, double v) { std::isnan(v) ? s.bind(i) : s.bind(i, v); }
inline void bind_one(SQLite::Statement& s, int i, std::int64_t v) { s.bind(i, v); }
inline void bind_one(SQLite::Statement& s, int i, int v) { s.bind(i, v); }
inline void bind_one(SQLite::Statement& s, int i, const std::string& v) { s.bind(i, v); }
template <class T>
void bind_one(SQLite::Statement& s, int i, const std::optional<T>& v) {
  v ? bind_one(s, i, *v) : s.bind(i);
}

template <class... Values>
void execute(SQLite::Statement& statement, const Values&... values) {
  statement.tryReset();  // an earlier failure was thrown when it happened
  int i = 0;
  (bind_one(statement, ++i, values), ...);
  statement.exec();
}

inline std::optional<std::string> or_null(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace mpmstudy
