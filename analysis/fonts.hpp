#pragma once
/// Which characters the fonts of this machine have: gnuplot draws a box where none has one.
#include <string>
#include <string_view>
#include <vector>

namespace analysis {

/// Characters of a UTF-8 text that no installed font has, each once, in their order.
std::vector<std::string> characters_without_font(std::string_view utf8);

/// The text with a question mark in place of each of these.
std::string drawable(std::string_view utf8);

}  // namespace analysis
