#pragma once
#include <chrono>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "runner/status/status.hpp"

namespace mpmstudy {

/// Seconds since some moment; a test puts its own in place.
using StatusClock = std::function<double()>;
StatusClock steady_status_clock();

struct PlainOptions {
  double progress_every_s = 30;    ///< of one job's lines [s]
  std::vector<std::string> swept;  ///< what a job's label shows
  bool quiet = false;              ///< failures and the summary only
  /// In place of `swept`: what sets a job apart within its study. Called under the lock of the display.
  std::function<std::string(const Job&)> label = {};
};

/// Lines for a pipe or a log file: the start and the end of every job, its progress now and then.
std::unique_ptr<Status> make_plain_status(std::ostream&, PlainOptions = {},
                                          StatusClock = steady_status_clock());

/// "[2/8] 1a2b3c4d5e6f done in 3.2 s (12345 particles, 678 steps, 6.10 M/s updates)  cavity_radius = 1 um",
/// at most `line_columns` long. Of a reason the first line, cut: `mpmstudy explain KEY` has the whole.
std::string end_line(std::int64_t number, std::int64_t of, const Job&, const JobEnd&,
                     const std::string& label);
/// What a run says before its first job, and after its last one. Several lines.
std::string start_text(const RunStart&);
std::string end_text(const RunEnd&);

}  // namespace mpmstudy
