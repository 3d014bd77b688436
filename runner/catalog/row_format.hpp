#pragma once
/// Rows as text. Doubles are written with the fewest digits that give the same bits back.
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "runner/catalog/query.hpp"

namespace mpmstudy {

enum class RowFormat {
  table,  ///< for people; columns aligned, null is empty
  /// RFC 4180: CRLF, quotes where needed; null is an empty field, an empty text is "". A text that could be
  /// taken for a number, a truth value or a missing one is quoted; infinity is inf.
  csv,
  json,  ///< an array of objects, one per line; infinity is the text "Infinity" or "-Infinity", null is null
};

/// "table", "csv", "json"
std::optional<RowFormat> row_format_from(std::string_view word);

/// A sink that writes to a stream, which must outlive it.
std::unique_ptr<RowSink> make_row_sink(RowFormat, std::ostream&);

/// "0.1", "1e-06", "inf": the shortest text of the same double.
std::string shortest(double);

}  // namespace mpmstudy
