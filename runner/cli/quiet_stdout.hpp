#pragma once

namespace mpmstudy {

/// While it lives, what is written to standard output goes to standard error: what a program reads from a
/// verb with
/// --json is then one object and nothing else. Throws std::system_error.
class QuietStdout {
 public:
  QuietStdout();
  ~QuietStdout();
  QuietStdout(const QuietStdout&) = delete;
  QuietStdout& operator=(const QuietStdout&) = delete;

 private:
  int stdout_;  ///< where it went before
};

}  // namespace mpmstudy
