#pragma once
#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace mpmstudy {

/// What a wrong command line is answered with: what is wrong, and for a misspelt verb or option the nearest
/// one. For CLI::App::failure_message of the whole program.
std::string usage_message(const CLI::App*, const CLI::Error&);

}  // namespace mpmstudy
