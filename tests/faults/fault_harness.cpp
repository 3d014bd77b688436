// SIGKILL at random moments, then `run` again, until nothing is left to do: is anything done lost, run twice,
// or another result than that of a run that nobody disturbed?
//
//   fault_harness --kills 300 [--seed S] [--program FILE] [--study FILE] [--folder DIR]
//   fault_harness --disk 100 [--every 7] [--seed S]
//   fault_harness --compare RESULTS RESULTS
//
// --disk: the disk fails at its n-th change, for n = 1, 1 + every, ...: once with "I/O error", and from then
// on with "no space left"; afterwards there is room again. Does the program say so, with 75 or 2, and go on
// to the same end?
//
// Each round is a fresh results folder: the program is started (every third time twice at once), killed after
// a time drawn between 0.5 ms and a second, and the catalog looked at; when the study is through, its rows
// and its files are compared with those of the undisturbed run. Rounds follow until so many processes were
// killed.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/field_files.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/rows_of.hpp"

namespace {

namespace fs = std::filesystem;
using namespace mpmstudy;

struct Options {
  int kills = 20;
  unsigned seed = 1;
  std::string program = PROGRAM, study = STUDY, folder;
  std::vector<std::string> compare;  ///< two results folders
  int disk = 0;                      ///< how many places of failure
  int every = 1;                     ///< the distance between them
};

struct Tally {
  int kills = 0, rounds = 0, starts = 0;
  int lost = 0, twice = 0, integrity = 0, different = 0, orphans = 0, refused = 0;
  bool clean() const { return lost + twice + integrity + different + orphans + refused == 0; }
};

pid_t start(const Options& options, const fs::path& results,
            const std::map<std::string, std::string>& environment = {}) {
  const pid_t child = fork();
  if (child != 0) return child;
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  const int log = open((results.string() + ".log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execl(options.program.c_str(), options.program.c_str(), "run", options.study.c_str(), "--results",
        results.c_str(), "-j", "2", "-q", nullptr);
  _exit(127);
}

/// Exit code, or 1000 + the signal that ended it.
int wait_for(pid_t child) {
  int end = 0;
  waitpid(child, &end, 0);
  return WIFEXITED(end) ? WEXITSTATUS(end) : 1000 + WTERMSIG(end);
}

std::int64_t number(const fs::path& results, const std::string& sql) {
  return std::get<std::int64_t>(query(results, sql).rows.at(0).at(0));
}

/// Paths under the results folder that are not the catalog's own.
std::set<std::string> files_of(const fs::path& results) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(results))
    if (const auto path = fs::relative(entry.path(), results).string(); !path.starts_with("catalog.db"))
      files.insert(path);
  return files;
}

/// What must hold at every moment. Gives back the keys that are done.
std::set<std::string> look(const fs::path& results, const std::set<std::string>& done_before, Tally& tally) {
  std::set<std::string> done;
  try {
    for (const auto& row : query(results, "SELECT DISTINCT key FROM jobs WHERE status = 'done'").rows)
      done.insert(std::get<std::string>(row[0]));
    tally.twice += static_cast<int>(number(results,
                                           "SELECT count(*) FROM (SELECT key FROM events WHERE to_status = "
                                           "'done' GROUP BY key HAVING count(*) > 1)"));
    SQLite::Database db(catalog_path(results).string(), SQLite::OPEN_READONLY, 30'000);
    tally.integrity += db.execAndGet("PRAGMA integrity_check").getString() != "ok";
  } catch (const std::exception& error) {
    // Killed before the catalog was made: the next start makes it.
    if (!done_before.empty()) {
      fmt::print("{}\n", error.what());
      ++tally.integrity;
    }
  }
  for (const auto& key : done_before)
    if (!done.contains(key)) ++tally.lost;
  return done;
}

struct Undisturbed {
  std::string rows;
  std::set<std::string> files;
};

/// Kills and starts again until the study is through.
void round(const Options& options, const fs::path& results, const Undisturbed& expected, std::mt19937& random,
           Tally& tally) {
  std::uniform_real_distribution<double> exponent(std::log(5e-4), std::log(1.0));
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

std::string last_line(const fs::path& log) {
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) last = line;
  return last;
}

/// The disk fails at its n-th change. False when the program made no so many.
bool fail_disk(const Options& options, int n, bool full, const Undisturbed& expected, Tally& tally,
               std::map<std::string, int>& said) {
  const fs::path folder = options.folder;
  const fs::path results = folder / fmt::format("disk-{}-{}", n, full ? "full" : "error");
  const fs::path mark = results.string() + ".mark", log = results.string() + ".log";
  for (const auto& old : {results, mark, log}) fs::remove_all(old);
  std::map<std::string, std::string> environment = {{"LD_PRELOAD", FAILING_DISK},
                                                    {"FAULT_AT", std::to_string(n)},
                                                    {"FAULT_ERRNO", std::to_string(full ? ENOSPC : EIO)},
                                                    {"FAULT_MARK", mark.string()}};
  if (!full) environment["FAULT_ONCE"] = "1";
  const int end = wait_for(start(options, results, environment));
  ++tally.starts;
  if (!fs::exists(mark)) return false;
  ++tally.kills;
  const std::string words = last_line(log);
  // 0: what failed was tried again, or need not have been written (a heartbeat, a checkpoint of the log).
  if (end != 0 && end != 75 && end != 2 && end != 1) {
    fmt::print("change {} fails: ended with {}: {}\n", n, end, words);
    ++tally.refused;
  } else if (end != 0 && words.empty()) {
    fmt::print("change {} fails: ended with {} and not a word\n", n, end);
    ++tally.refused;
  }
  ++said[fmt::format("{}", end)];
  const auto done = fs::exists(results) ? look(results, {}, tally) : std::set<std::string>();
  if (const int after = wait_for(start(options, results)); after != 0) {
    fmt::print("change {} failed: with room again it ended with {}: {}\n", n, after, last_line(log));
    ++tally.refused;
    return true;
  }
  look(results, done, tally);
  const bool same = rows_of(results) == expected.rows && files_of(results) == expected.files;
  if (!same) fmt::print("change {} failed: another end, see {}\n", n, results.string());
  tally.different += !same;
  if (same) fs::remove_all(results);
  return true;
}

int fail_disks(const Options& options, const Undisturbed& expected) {
  Tally tally;
  std::map<std::string, int> said;
  for (int i = 0; i < options.disk; ++i) {
    const int n = 1 + i * options.every;
    if (!fail_disk(options, n, i % 2 == 0, expected, tally, said)) break;
  }
  std::string codes;
  for (const auto& [code, count] : said) codes += fmt::format(" {} x {}", count, code);
  fmt::print(
      "{} failures of the disk, ended with{}: {} done jobs lost, {} run twice, {} integrity errors, {} other "
      "ends, {} "
      "without a word or never again\n",
      tally.kills, codes, tally.lost, tally.twice, tally.integrity, tally.different, tally.refused);
  return tally.clean() ? 0 : 1;
}

int run(const Options& options) {
  const fs::path folder = options.folder;
  fs::create_directories(folder);
  const fs::path calm = folder / "undisturbed";
  if (const int end = wait_for(start(options, calm)); end != 0) {
    fmt::print("the undisturbed run ended with {}, see {}.log\n", end, calm.string());
    return 1;
  }
  const Undisturbed expected{rows_of(calm), files_of(calm)};
  if (options.disk > 0) return fail_disks(options, expected);
  std::mt19937 random(options.seed);
  Tally tally;
  while (tally.kills < options.kills && tally.refused <= 20) {
    const fs::path results = folder / fmt::format("round-{}", tally.rounds + 1);
    fs::remove_all(results);
    const Tally before = tally;
    round(options, results, expected, random, tally);
    if (tally.rounds > before.rounds && tally.clean()) fs::remove_all(results);
  }
  fmt::print(
      "{} kills in {} starts, {} studies brought to their end: {} done jobs lost, {} run twice, {} integrity "
      "errors, {} catalogs or files that differ, {} folders with other files, {} starts refused (seed {})\n",
      tally.kills, tally.starts, tally.rounds, tally.lost, tally.twice, tally.integrity, tally.different,
      tally.orphans, tally.refused, options.seed);
  return tally.clean() ? 0 : 1;
}

int compare(const fs::path& one, const fs::path& other) {
  const bool same = rows_of(one) == rows_of(other);
  fmt::print("{} and {}: {}\n", one.string(), other.string(),
             same ? "the same to the last bit" : "different");
  return same ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.folder = (fs::temp_directory_path() / fmt::format("mpmstudy-faults-{}", getpid())).string();
  CLI::App app("Kills runs at random moments and looks for damage");
  app.add_option("--kills", options.kills, "How many processes to kill")->capture_default_str();
  app.add_option("--disk", options.disk, "Instead: how many failures of the disk");
  app.add_option("--every", options.every, "Changes of the disk between two failures")->capture_default_str();
  app.add_option("--seed", options.seed, "Of the moments")->capture_default_str();
  app.add_option("--program", options.program, "mpmstudy")->capture_default_str();
  app.add_option("--study", options.study, "Study file")->capture_default_str();
  app.add_option("--folder", options.folder, "For its results")->capture_default_str();
  app.add_option("--compare", options.compare, "Only compare the catalogs of two results folders")
      ->expected(2);
  CLI11_PARSE(app, argc, argv);
  try {
    if (!options.compare.empty()) return compare(options.compare[0], options.compare[1]);
    const int code = run(options);
    if (code == 0) fs::remove_all(options.folder);
    return code;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
