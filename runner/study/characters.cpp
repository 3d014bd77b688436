#include "runner/study/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace mpmstudy {
namespace {

/// Ranges of code points that are named in messages, the first that fits.
struct Named {
  std::uint32_t first, last;
  std::string_view name;
};
constexpr Named names[] = {
    {0x00A0, 0x00A0, ", a no-break space"},
    {0x00AD, 0x00AD, ", a soft hyphen"},
    {0x2000, 0x200A, ", a space of another width"},
    {0x200B, 0x200F, ", which is invisible"},
    {0x2010, 0x2015, ", a dash"},
    {0x2018, 0x201F, ", a typographic quotation mark"},
    {0x202F, 0x202F, ", a narrow no-break space"},
    {0x205F, 0x206F, ", which is invisible"},
    {0x2212, 0x2212, ", a minus sign other than that of the keyboard"},
    {0x3000, 0x3000, ", a wide space"},
    {0xFEFF, 0xFEFF, ", which is invisible"},
    {0xFF01, 0xFF5E, ", a wide character"},
};

/// Of units: micro sign and Greek mu, degree, superscripts, middle dot, ohm, angstrom.
constexpr std::uint32_t of_units[] = {0x00B5, 0x03BC, 0x00B0, 0x00B2, 0x00B3, 0x00B9, 0x00B7, 0x22C5,
                                      0x2126, 0x03A9, 0x212B, 0x00C5, 0x00D7, 0x2070, 0x207B};

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
};

/// The character at the start of a text; a byte that is not UTF-8 stands for itself.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t bytes = byte(0) < 0xC0 ? 1 : byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (bytes == 1 || bytes > text.size()) return {byte(0), 1};
  std::uint32_t code = byte(0) & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0u) != 0x80) return {0, i};  // cut short: no character at all
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  return {code, bytes};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::string without_controls(std::string_view text, std::string_view kept) {
  std::string shown;
  while (!text.empty()) {
    const Character c = first_character(text);
    const std::string_view bytes = text.substr(0, c.bytes);
    text.remove_prefix(c.bytes);
    if (c.code == 0 && bytes[0] != '\0')
      shown += "\\uFFFD";  // a character that is cut short
    else if (!is_control(c.code) || kept.find(bytes) != std::string_view::npos)
      shown += bytes;
    else
      shown += fmt::format("\\u{:04X}", c.code);
  }
  return shown;
}

}  // namespace

std::string control_character(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    if (is_control(c.code)) return fmt::format("holds U+{:04X}, a control character", c.code);
    text.remove_prefix(c.bytes);
  }
  return {};
}

std::string printable(std::string_view text) { return without_controls(text, ""); }

std::string printable_lines(std::string_view text) { return without_controls(text, "\n\t"); }

std::string odd_character(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    text.remove_prefix(c.bytes);
    const bool superscript = c.code >= 0x2074 && c.code <= 0x2079;
    if (c.code < 0x80 || superscript || std::ranges::find(of_units, c.code) != std::end(of_units)) continue;
    std::string_view name;
    for (const Named& known : names)
      if (name.empty() && c.code >= known.first && c.code <= known.last) name = known.name;
    return fmt::format("holds U+{:04X}{}", c.code, name);
  }
  return {};
}

std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace mpmstudy
