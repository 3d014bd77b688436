#pragma once
/// `mpmstudy check FILE...`: are these studies valid?
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct CheckOptions {
  std::vector<std::string> files;
  StudyOptions study;
};
void setup_check(CLI::App&);

/// Prints "ok: NAME, N jobs" per valid file, the mistakes of the others on stderr; exit_usage if there are
/// any.
int run_check(const CheckOptions&);

}  // namespace mpmstudy
