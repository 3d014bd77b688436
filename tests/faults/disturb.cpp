// Signals of every kind, two machines whose clocks are 120 s apart, two process namespaces: then `run` again,
// until nothing is left to do. Is anything done lost, stored twice, counted and not stored, or another result
// than that of a run that nobody disturbed?
//
// Each study is a fresh results folder, with one runner, two, two of different "hosts" (other_machine.c), or
// one beside one in a namespace of its own. All of a study's runners are disturbed at a random moment: KILL,
// HUP, TERM, a reader of their output that goes, or STOP and CONT a while later. Rounds follow until so many
// disturbances have hit a living process.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <random>
#include <sstream>

#include "runner/catalog/query.hpp"
#include "tests/faults/harness.hpp"

namespace mpmstudy::faults {
namespace {

namespace fs = std::filesystem;

/// Twelve of these without a sign of life and a runner that cannot be looked for is taken for gone.
constexpr const char* heartbeat = "0.25 s";

enum class Where { one, two, hosts, namespaces };
constexpr const char* names_of_where[] = {"one runner", "two runners", "two hosts", "two namespaces"};
enum class What { kill, hangup, terminate, pipe, stop };
constexpr const char* names_of_what[] = {"KILL", "HUP", "TERM", "PIPE", "STOP/CONT"};

struct Runner {
  pid_t child = -1;  ///< of this process: the program, or the `unshare` that started it
  int output = -1;   ///< the end of a pipe that is read, or not
  std::string log;   ///< what was read from it
  bool killed = false;
  bool inside = false;  ///< of a namespace
};

bool can_unshare() { return std::system("unshare -Urpf --mount-proc true 2> /dev/null") == 0; }

/// The program itself, which takes the signals: the only child of `unshare`; 0: not yet, or no longer.
pid_t program_of(const Runner& runner) {
  if (!runner.inside) return runner.child;
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", runner.child));
  pid_t first = 0;
  children >> first;
  return first;
}

class Disturbance {
 public:
  Disturbance(const Options& options, const Undisturbed& expected, fs::path results, Where where,
              std::mt19937& random, Tally& tally)
      : options_(options),
        expected_(expected),
        results_(std::move(results)),
        where_(where),
        random_(random),
        tally_(tally) {}

  /// Until the study is through, or has been refused too often.
  void run(std::map<What, int>& hits) {
    std::uniform_real_distribution<double> exponent(std::log(5e-3), std::log(expected_.seconds));
    while (!through_ && tally_.refused <= 20) {
      std::vector<Runner> runners;
      for (int i = 0; i < (where_ == Where::one ? 1 : 2); ++i) runners.push_back(start(i));
      tally_.starts += static_cast<int>(runners.size());
      usleep(static_cast<useconds_t>(1e6 * std::exp(exponent(random_))));
      const auto what = static_cast<What>(random_() % 5);
      if (tally_.kills < options_.disturb)
        for (Runner& runner : runners) {
          if (where_ != Where::one && random_() % 2 == 0) continue;  // mostly one of the two
          if (!disturb(runner, what)) continue;
          ++tally_.kills;
          ++hits[what];
        }
      for (Runner& runner : runners) finish(runner);
      done_ = look(results_, done_, tally_);
    }
    if (!same_end(results_, expected_)) ++tally_.different;
    ++tally_.rounds;
  }

 private:
  Runner start(int i) {
    Runner runner;
    runner.inside = where_ == Where::namespaces && i == 1;
    std::map<std::string, std::string> environment;
    if (where_ == Where::hosts) {
      const std::string boot = results_.string() + fmt::format(".boot-{}", i);
      std::ofstream(boot) << "0000000" << i << "\n";
      environment = {{"LD_PRELOAD", OTHER_MACHINE},
                     {"FAKE_HOST", fmt::format("host-{}", i)},
                     {"FAKE_BOOT", boot},
                     {"FAKE_CLOCK", i == 0 ? "60" : "-60"}};
      if (random_() % 2 == 0) environment["FAKE_CLOCK_STEPS"] = "1";
    }
    std::vector<std::string> words = {
        options_.program, "run", options_.study, "--results", results_, "-j", "2", "--heartbeat", heartbeat};
    if (runner.inside) words.insert(words.begin(), {"unshare", "-Urpf", "--mount-proc", "--kill-child=KILL"});
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    runner.child = start_words(words, environment, ends[1], results_.string() + ".log");
    close(ends[1]);
    runner.output = ends[0];
    fcntl(runner.output, F_SETFL, O_NONBLOCK);
    return runner;
  }

  /// False if the runner has ended before.
  bool disturb(Runner& runner, What what) {
    const pid_t program = program_of(runner);
    if (program == 0 || has_ended(runner.child)) return false;
    switch (what) {
      case What::kill:
        runner.killed = true;
        return kill(program, SIGKILL) == 0;
      case What::hangup:
        return kill(program, SIGHUP) == 0;
      case What::terminate:
        return kill(program, SIGTERM) == 0;
      case What::pipe:
        close(runner.output);
        runner.output = -1;
        return true;
      case What::stop:
        break;
    }
    if (kill(program, SIGSTOP) != 0) return false;
    usleep(static_cast<useconds_t>(random_() % 500'000));
    kill(program, SIGCONT);
    return true;
  }

  static bool has_ended(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == child;
  }

  void read_output(Runner& runner) {
    char block[4096];
    for (ssize_t got = 1; runner.output >= 0 && got > 0;)
      if (got = read(runner.output, block, sizeof block); got > 0)
        runner.log.append(block, static_cast<std::size_t>(got));
  }

  void finish(Runner& runner) {
    while (!has_ended(runner.child)) {
      read_output(runner);
      usleep(5'000);
    }
    read_output(runner);
    if (runner.output >= 0) close(runner.output);
    const int end = wait_for(runner.child);
    if (end == 0) {
      through_ = true;
      check_all_stored();
    } else if (runner.inside && runner.killed && end == 1) {
      // What some versions of unshare end with when their child was killed.
    } else if (end != 75 && end != 1000 + SIGKILL && end != 1000 + SIGHUP && end != 1000 + SIGTERM) {
      // By HUP and TERM itself: before the program could say what it does with them.
      fmt::print("{}: ended with {}: {}; see {}.log\n", names_of_where[static_cast<int>(where_)], end,
                 runner.log, results_.string());
      ++tally_.refused;
    }
    check_counted(runner.log);
  }

  /// Who ends with 0 says that every job is decided.
  void check_all_stored() {
    const auto open = query(results_, "SELECT key FROM jobs WHERE status <> 'done'").rows.size();
    if (open > 0) {
      fmt::print("{}: ended with 0, and {} jobs are not done\n", results_.string(), open);
      ++tally_.uncounted;
    }
  }

  /// What a runner has printed as done is stored, and nobody else has printed it.
  void check_counted(const std::string& log) {
    std::istringstream lines(log);
    for (std::string line, number, key, done; std::getline(lines, line);) {
      std::istringstream words(line);
      if (!(words >> number >> key >> done) || done != "done" || !number.starts_with("[")) continue;
      const auto rows =
          query(results_, "SELECT DISTINCT key FROM jobs WHERE status = 'done' AND key GLOB '" + key + "*'");
      if (rows.rows.size() == 1 && counted_.insert(key).second) continue;
      fmt::print("{}: {} is counted, and {}\n", results_.string(), key,
                 rows.rows.size() == 1 ? "was counted before" : "is not stored");
      ++tally_.uncounted;
    }
  }

  const Options& options_;
  const Undisturbed& expected_;
  const fs::path results_;
  const Where where_;
  std::mt19937& random_;
  Tally& tally_;
  bool through_ = false;
  std::set<std::string> done_, counted_;
};

}  // namespace

int disturb_runs(const Options& options, const Undisturbed& expected) {
  std::mt19937 random(options.seed);
  Tally tally;
  std::map<What, int> hits;
  std::map<Where, int> studies;
  const bool namespaces = can_unshare();
  if (!namespaces) fmt::print("no process namespaces here (unshare -Urpf): studies without them\n");
  for (int i = 0; tally.kills < options.disturb && tally.refused <= 20; ++i) {
    const auto where = static_cast<Where>(i % (namespaces ? 4 : 3));
    const fs::path results = fs::path(options.folder) / fmt::format("study-{}", i + 1);
    fs::remove_all(results);
    Disturbance(options, expected, results, where, random, tally).run(hits);
    ++studies[where];
    if (tally.clean()) fs::remove_all(results);
  }
  std::string of;
  for (const auto& [what, count] : hits)
    of += fmt::format("{}{} {}", of.empty() ? "" : ", ", count, names_of_what[static_cast<int>(what)]);
  std::string with;
  for (const auto& [where, count] : studies)
    with +=
        fmt::format("{}{} with {}", with.empty() ? "" : ", ", count, names_of_where[static_cast<int>(where)]);
  fmt::print(
      "{} disturbances ({}) in {} starts; {} studies brought to their end ({}): {} done jobs lost, {} stored "
      "twice, {} counted and not stored, {} integrity errors, {} other ends, {} starts refused (seed {}; "
      "undisturbed it takes {:.2f} s)\n",
      tally.kills, of, tally.starts, tally.rounds, with, tally.lost, tally.twice, tally.uncounted,
      tally.integrity, tally.different, tally.refused, options.seed, expected.seconds);
  return tally.clean() ? 0 : 1;
}

}  // namespace mpmstudy::faults
