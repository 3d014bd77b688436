#pragma once
/// Characters that look like others (what a page or a word processor leaves in a text that is pasted), and
/// those that are not shown at all.
#include <string>
#include <string_view>

namespace mpmstudy {

/// The first character of UTF-8 text that no name, number or unit has, for a message: "holds U+00A0, a
/// no-break space". Empty if there is none. Letters of units (the micro sign, degree, superscripts) are in
/// order.
std::string odd_character(std::string_view text);

/// The first character that controls a terminal instead of being shown, for a message: "holds U+001B, a
/// control character". Line ends, the order of letters (U+202E) and the controls of 8-bit terminals are among
/// them. Empty if there is none.
std::string control_character(std::string_view text);

/// How many characters UTF-8 text has: continuation bytes are none.
std::size_t characters_in(std::string_view text);

/// Text of a file or a command line, as it may go to a terminal: what control_character() finds is written as
/// TOML writes it, "\u001B". Lines: line ends and tabs stay.
std::string printable(std::string_view text);
std::string printable_lines(std::string_view text);

}  // namespace mpmstudy
