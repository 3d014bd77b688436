#include "runner/cli/quiet_stdout.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <system_error>

namespace mpmstudy {
namespace {

void flush() {
  std::cout.flush();
  std::fflush(stdout);
}

}  // namespace

QuietStdout::QuietStdout() {
  flush();
  stdout_ = dup(STDOUT_FILENO);
  if (stdout_ < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw std::system_error(errno, std::generic_category(), "standard output");
}

QuietStdout::~QuietStdout() {
  flush();
  dup2(stdout_, STDOUT_FILENO);
  close(stdout_);
}

}  // namespace mpmstudy
