// The disk fails at its n-th change, for n = 1, 1 + every, ...: once with "I/O error", and from then on with
// "no space left"; afterwards there is room again. Does the program say so, with 75 or 2, and go on to the
// same end?
#include <fmt/format.h>

#include <cerrno>
#include <set>

#include "tests/faults/harness.hpp"

namespace mpmstudy::faults {
namespace {

namespace fs = std::filesystem;

struct Failure {
  const char* name;
  int error;
  bool once;
};
constexpr Failure failures[] = {{"full", ENOSPC, false}, {"error", EIO, true}};

/// The disk fails at its n-th change. False when the program made no so many.
bool fail_disk(const Options& options, int n, const Failure& failure, const Undisturbed& expected,
               Tally& tally, std::map<int, int>& ends) {
  const fs::path results = fs::path(options.folder) / fmt::format("disk-{}-{}", n, failure.name);
  const fs::path mark = results.string() + ".mark";
  for (const auto& old : {results, mark, fs::path(results.string() + ".log")}) fs::remove_all(old);
  std::map<std::string, std::string> environment = {{"LD_PRELOAD", FAILING_DISK},
                                                    {"FAULT_AT", std::to_string(n)},
                                                    {"FAULT_ERRNO", std::to_string(failure.error)},
                                                    {"FAULT_MARK", mark.string()}};
  if (failure.once) environment["FAULT_ONCE"] = "1";
  const int end = wait_for(start(options, results, environment));
  ++tally.starts;
  if (!fs::exists(mark)) return false;
  ++tally.kills;
  const std::string words = words_of(results);
  // 0: what failed was tried again, or need not have been written (a heartbeat, a checkpoint of the log).
  if (end != 0 && end != 75 && end != 2 && end != 1) {
    fmt::print("change {} fails ({}): ended with {}: {}\n", n, failure.name, end, words);
    ++tally.refused;
  } else if (end != 0 && words.find(results.string()) == std::string::npos) {
    fmt::print("change {} fails ({}): ended with {} and names no path: {}\n", n, failure.name, end, words);
    ++tally.refused;
  }
  ++ends[end];
  const auto done = fs::exists(results) ? look(results, {}, tally) : std::set<std::string>();
  if (const int after = wait_for(start(options, results)); after != 0) {
    fmt::print("change {} failed ({}): with room again it ended with {}: {}\n", n, failure.name, after,
               words_of(results));
    ++tally.refused;
    return true;
  }
  look(results, done, tally);
  const bool same = same_end(results, expected);
  if (!same) fmt::print("change {} failed ({}): another end, see {}\n", n, failure.name, results.string());
  tally.different += !same;
  if (same) fs::remove_all(results);
  return true;
}

}  // namespace

int fail_disks(const Options& options, const Undisturbed& expected) {
  Tally tally;
  std::map<int, int> ends;
  int changes = 0;
  bool more = true;
  for (int i = 0; more && i < options.disk; ++i) {
    changes = 1 + i * options.every;
    for (const Failure& failure : failures)
      more = fail_disk(options, changes, failure, expected, tally, ends) && more;
  }
  std::string codes;
  for (const auto& [code, count] : ends) codes += fmt::format(" {} x {}", count, code);
  fmt::print(
      "{} failures of the disk at changes 1 to {}{}, ended with{}: {} done jobs lost, {} run twice, {} "
      "integrity errors, {} other ends, {} without a word or never again\n",
      tally.kills, changes, more ? "" : " (the last)", codes, tally.lost, tally.twice, tally.integrity,
      tally.different, tally.refused);
  return tally.clean() ? 0 : 1;
}

}  // namespace mpmstudy::faults
