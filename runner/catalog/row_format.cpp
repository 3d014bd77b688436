#include "runner/catalog/row_format.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>

#include "runner/study/characters.hpp"

namespace mpmstudy {
namespace {

bool is_number(const SqlValue& value) { return value.index() == 1 || value.index() == 2; }

std::string plain_text(const SqlValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* real = std::get_if<double>(&value)) return shortest(*real);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return {};
}

class CsvSink : public RowSink {
 public:
  explicit CsvSink(std::ostream& out) : out_(out) {}

  void columns(std::span<const std::string> names) override {
    for (std::size_t i = 0; i < names.size(); ++i) out_ << (i ? "," : "") << field(names[i]);
    out_ << "\r\n";
  }
  void row(std::span<const SqlValue> values) override {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto* text = std::get_if<std::string>(&values[i]);
      out_ << (i ? "," : "") << (text ? field(*text) : plain_text(values[i]));
    }
    out_ << "\r\n";
  }

 private:
  /// Quotes tell readers that look at them (QUOTE_NONNUMERIC of Python's csv) that a field is text.
  static bool looks_like_no_text(const std::string& text) {
    char* end = nullptr;
    std::strtod(text.c_str(), &end);  // numbers, inf and nan; hexadecimal ones with 0x
    if (end != text.c_str() && *end == '\0') return true;
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](char c) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    constexpr std::string_view words[] = {"true", "false", "na", "n/a", "null", "none"};
    return std::ranges::find(words, small) != std::end(words);
  }

  static std::string field(const std::string& text) {
    if (!text.empty() && text.find_first_of(",\"\r\n") == std::string::npos && !looks_like_no_text(text))
      return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted += '"';
  }

  std::ostream& out_;
};

class JsonSink : public RowSink {
 public:
  explicit JsonSink(std::ostream& out) : out_(out) {}

  void columns(std::span<const std::string> names) override {
    for (const auto& name : names) names_.push_back(quoted(name));
    out_ << "[";
  }
  void row(std::span<const SqlValue> values) override {
    out_ << (first_ ? "\n{" : ",\n{");
    first_ = false;
    for (std::size_t i = 0; i < values.size(); ++i)
      out_ << (i ? ", " : "") << names_[i] << ": " << json(values[i]);
    out_ << "}";
  }
  void end() override { out_ << (first_ ? "]\n" : "\n]\n"); }

 private:
  static std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  static std::string json(const SqlValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
    if (const auto* real = std::get_if<double>(&value)) {
      if (std::isnan(*real)) return "null";
      if (std::isinf(*real)) return *real > 0 ? "\"Infinity\"" : "\"-Infinity\"";
    }
    return is_number(value) ? plain_text(value) : "null";
  }

  std::ostream& out_;
  std::vector<std::string> names_;
  bool first_ = true;
};

class TableSink : public RowSink {
 public:
  explicit TableSink(std::ostream& out) : out_(out) {}

  void columns(std::span<const std::string> names) override {
    lines_.emplace_back(names.begin(), names.end());
    right_.assign(names.size(), true);
  }
  void row(std::span<const SqlValue> values) override {
    auto& line = lines_.emplace_back();
    for (std::size_t i = 0; i < values.size(); ++i) {
      line.push_back(one_line(plain_text(values[i])));
      if (values[i].index() == 3) right_[i] = false;
    }
  }
  void end() override {
    std::vector<std::size_t> widths(right_.size(), 0);
    for (const auto& line : lines_)
      for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], characters_in(line[i]));
    for (std::size_t n = 0; n < lines_.size(); ++n) {
      print(lines_[n], widths);
      if (n == 0) {
        std::vector<std::string> rule;
        for (const auto w : widths) rule.emplace_back(w, '-');
        print(rule, widths);
      }
    }
  }

 private:
  static std::string one_line(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto byte = static_cast<unsigned char>(text[i]);
      const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
      if (byte < 0x20 || byte == 0x7f)
        text[i] = ' ';
      else if (byte == 0xC2 && next >= 0x80 && next < 0xA0)  // U+0080 to U+009F, controls of 8-bit terminals
        text.replace(i, 2, " ");
    }
    return text;
  }
  void print(const std::vector<std::string>& line, const std::vector<std::size_t>& widths) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string blanks(widths[i] - characters_in(line[i]), ' ');
      text += (i ? "  " : "") + (right_[i] ? blanks + line[i] : line[i] + blanks);
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    out_ << text << "\n";
  }

  std::ostream& out_;
  std::vector<std::vector<std::string>> lines_;
  std::vector<bool> right_;
};

}  // namespace

std::optional<RowFormat> row_format_from(std::string_view word) {
  if (word == "table") return RowFormat::table;
  if (word == "csv") return RowFormat::csv;
  if (word == "json") return RowFormat::json;
  return std::nullopt;
}

std::unique_ptr<RowSink> make_row_sink(RowFormat format, std::ostream& out) {
  switch (format) {
    case RowFormat::csv:
      return std::make_unique<CsvSink>(out);
    case RowFormat::json:
      return std::make_unique<JsonSink>(out);
    case RowFormat::table:
      break;
  }
  return std::make_unique<TableSink>(out);
}

std::string shortest(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  std::string shortest(text, end);
  // "5" would come back as an integer.
  if (shortest.find_first_not_of("-0123456789") == std::string::npos) shortest += ".0";
  return shortest;
}

}  // namespace mpmstudy
