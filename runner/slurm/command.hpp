#pragma once
/// A command of another program: run without a shell, its two outputs apart, for a bounded time.
#include <string>
#include <vector>

namespace mpmstudy {

struct CommandAnswer {
  int code = 0;            ///< exit code; 128 + signal; 127 where the program is not there
  bool started = true;     ///< false: there is no such program
  bool timed_out = false;  ///< it was ended because it gave no answer in time
  std::string out, err;

  /// What it said and how it ended, on one line, for a message.
  std::string words() const;
};

/// Runs `words[0]`, found by PATH. `drop`: variables of the environment that it does not get; a name that
/// ends in '*' stands for all that begin so. After `seconds` it is ended, with the processes that it started.
CommandAnswer run_command(const std::vector<std::string>& words, double seconds,
                          const std::vector<std::string>& drop = {});

}  // namespace mpmstudy
