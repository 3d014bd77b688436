// SIGKILL at random moments, then `run` again, until nothing is left to do: is anything done lost, run twice,
// or another result than that of a run that nobody disturbed?
//
// Each round is a fresh results folder: the program is started (every third time twice at once), killed after
// a time drawn between 0.5 ms and what the whole study takes when nobody disturbs it (evenly in its
// logarithm: as often in the first hundredth as in the last nine tenths), and the catalog looked at; when the
// study is through, its rows and its files are compared with those of the undisturbed run. Rounds follow
// until so many processes were killed.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <random>

#include "runner/catalog/field_files.hpp"
#include "runner/catalog/query.hpp"
#include "tests/faults/harness.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy::faults {
namespace {

namespace fs = std::filesystem;

/// Kills and starts again until the study is through.
void round(const Options& options, const fs::path& results, const Undisturbed& expected, std::mt19937& random,
           Tally& tally) {
  std::uniform_real_distribution<double> exponent(std::log(5e-4), std::log(expected.seconds));
  std::set<std::string> done;
  bool through = false;
  while (!through) {
    std::vector<pid_t> children;
    const int count = random() % 3 == 0 ? 2 : 1;
    for (int i = 0; i < count; ++i) children.push_back(start(options, results));
    tally.starts += count;
    usleep(static_cast<useconds_t>(1e6 * std::exp(exponent(random))));
    const bool kill_now = tally.kills < options.kills;
    for (const pid_t child : children)
      if (kill_now) kill(child, SIGKILL);
    for (const pid_t child : children) {
      const int end = wait_for(child);
      if (end == 1000 + SIGKILL) {
        ++tally.kills;
      } else if (end == 0) {
        through = true;
      } else {
        fmt::print("ended with {}, see {}.log\n", end, results.string());
        ++tally.refused;
        if (tally.refused > 20) return;
      }
    }
    done = look(results, done, tally);
  }
  if (rows_of(results) != expected.rows) ++tally.different;
  if (files_of(results) != expected.files) ++tally.orphans;
  for (const auto& row : query(results, "SELECT path, bytes, checksum FROM snapshots").rows)
    if (const auto wrong = what_is_wrong(results / std::get<std::string>(row[0]),
                                         std::get<std::int64_t>(row[1]), std::get<std::string>(row[2]));
        !wrong.empty())
      ++tally.different;
  ++tally.rounds;
}

}  // namespace

int kill_runs(const Options& options, const Undisturbed& expected) {
  std::mt19937 random(options.seed);
  Tally tally;
  while (tally.kills < options.kills && tally.refused <= 20) {
    const fs::path results = fs::path(options.folder) / fmt::format("round-{}", tally.rounds + 1);
    fs::remove_all(results);
    const Tally before = tally;
    round(options, results, expected, random, tally);
    if (tally.rounds > before.rounds && tally.clean()) fs::remove_all(results);
  }
  fmt::print(
      "{} kills in {} starts, {} studies brought to their end: {} done jobs lost, {} run twice, {} integrity "
      "errors, {} catalogs or files that differ, {} folders with other files, {} starts refused (seed {}; "
      "undisturbed it takes {:.2f} s)\n",
      tally.kills, tally.starts, tally.rounds, tally.lost, tally.twice, tally.integrity, tally.different,
      tally.orphans, tally.refused, options.seed, expected.seconds);
  return tally.clean() ? 0 : 1;
}

}  // namespace mpmstudy::faults
