#pragma once
#include <string>

namespace mpmstudy {

/// A word for the shell, in quotes where it needs them: for scripts, and for commands that a message tells
/// the user to give.
std::string shell_word(const std::string&);

}  // namespace mpmstudy
