#pragma once
/// Characters that look like others: what a page or a word processor leaves in a text that is pasted.
#include <string>
#include <string_view>

namespace mpmstudy {

/// The first character of UTF-8 text that no name, number or unit has, for a message: "holds U+00A0, a
/// no-break space". Empty if there is none. Letters of units (the micro sign, degree, superscripts) are in
/// order.
std::string odd_character(std::string_view text);

}  // namespace mpmstudy
