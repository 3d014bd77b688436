#pragma once
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "runner/status/plain_status.hpp"
#include "runner/status/status.hpp"

namespace mpmstudy {

struct TerminalOptions {
  double redraw_every_s = 0.1;
  std::size_t most_lines = 12;                        ///< running jobs shown at once; the others are counted
  std::function<std::size_t()> width;                 ///< columns of the terminal, asked at every redraw
  std::vector<std::string> swept;                     ///< what a job's label shows
  std::function<std::string(const Job&)> label = {};  ///< as of PlainOptions
};

/// A block at the foot of a terminal that is drawn anew: one line per running job and one for the whole run.
/// Ends of jobs scroll away above it.
std::unique_ptr<Status> make_terminal_status(std::ostream&, TerminalOptions = {},
                                             StatusClock = steady_status_clock());

/// Columns of the terminal on standard error or output; 80 where there is none.
std::size_t terminal_width();

}  // namespace mpmstudy
