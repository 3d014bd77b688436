#pragma once
/// What all verbs share: exit codes, options, how a verb ends. One file per verb: an options struct,
/// `setup_VERB(CLI::App&)` that adds the subcommand, `run_VERB(const Options&)` that does it.
#include <string>
#include <vector>

#include "runner/study/study.hpp"

namespace CLI {
class App;
}

namespace mpmstudy {

/// Exit codes of the program.
inline constexpr int exit_ok = 0;             ///< everything asked for is decided
inline constexpr int exit_failed = 1;         ///< some jobs failed, or the program itself did
inline constexpr int exit_usage = 2;          ///< usage or invalid study; nothing was written
inline constexpr int exit_stopped = 75;       ///< stopped with work left: run again to go on
inline constexpr int exit_interrupted = 130;  ///< by Ctrl-C

/// --set KEY=VALUE, --cells FACTOR, --yes: what a verb that reads studies offers.
struct StudyOptions {
  std::vector<std::string> set;
  double cells = 1;
  bool yes = false;
  bool cells_told = false;  ///< --cells stands on the command line, if only as 1
};
void add_study_options(CLI::App& verb, StudyOptions&);

/// Reads a study as the options say. Throws StudyError.
Study read_study(const std::string& path, const StudyOptions&);

/// --results DIR, by default "results".
void add_results_option(CLI::App& verb, std::string& results);

/// Ends a verb: call it last in the subcommand's callback, end_with(run_check(*options)).
[[noreturn]] void end_with(int exit_code);

}  // namespace mpmstudy
