// Folders that cannot be written: the results folder, its `fields`, and the one that it is to be made in.
// Does the program name what it cannot write, leave everything as it is, still answer, and go on when it may?
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/faults/harness.hpp"

namespace mpmstudy::faults {
namespace {

namespace fs = std::filesystem;

constexpr auto writing = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;

void set_writable(const fs::path& path, bool writable) {
  fs::permissions(path, writing, writable ? fs::perm_options::add : fs::perm_options::remove);
  if (writable)
    fs::permissions(path, fs::perms::group_write | fs::perms::others_write, fs::perm_options::remove);
}

void set_all_writable(const fs::path& folder, bool writable) {
  set_writable(folder, true);
  for (const auto& entry : fs::recursive_directory_iterator(folder)) set_writable(entry.path(), writable);
  set_writable(folder, writable);
}

std::string bytes_of(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Ends a run, as Ctrl-C does, when some of its jobs are done.
void run_half(const Options& options, const fs::path& results) {
  const pid_t run = start(options, results);
  for (int i = 0; i < 600; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    try {
      if (std::get<std::int64_t>(
              query(results, "SELECT count(*) FROM jobs WHERE status = 'done'").rows.at(0).at(0)) > 0)
        break;
    } catch (const std::exception&) {  // no catalog yet
    }
  }
  kill(run, SIGTERM);
  wait_for(run);
}

class ReadOnly {
 public:
  ReadOnly(const Options& options, const Undisturbed& expected) : options_(options), expected_(expected) {}

  int run() {
    const fs::path folder = fs::path(options_.folder) / "read-only";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const fs::path results = folder / "results";

    set_writable(folder, false);
    refuses("a folder to be made where nothing can be", results, results, 2);
    set_writable(folder, true);

    run_half(options_, results);
    const std::string before = bytes_of(catalog_path(results));
    set_all_writable(results, false);
    refuses("a results folder that cannot be written", results, catalog_path(results), 2);
    expect("the catalog is as it was", bytes_of(catalog_path(results)) == before);
    // status ends with 75: half of the work is left
    for (const auto& [words, code] :
         {std::pair(std::vector<std::string>{"status", "--results", results.string()}, 75),
          std::pair(
              std::vector<std::string>{"query", "SELECT count(*) FROM jobs", "--results", results.string()},
              0)})
      expect(words[0] + " answers", wait_for(start(options_, results, {}, words)) == code);
    set_all_writable(results, true);

    set_all_writable(results / "fields", false);
    refuses("fields that cannot be written", results, results / "fields", 75);
    set_all_writable(results / "fields", true);

    expect("with leave to write it goes on", wait_for(start(options_, results)) == 0);
    Tally tally;
    look(results, {}, tally);
    expect("nothing is lost, run twice or damaged", tally.clean());
    expect("the same end", same_end(results, expected_));
    fmt::print("{} of {} expectations hold\n", good_, asked_);
    return good_ == asked_ ? 0 : 1;
  }

 private:
  void expect(const std::string& what, bool holds) {
    ++asked_;
    good_ += holds;
    if (!holds) fmt::print("not so: {}\n", what);
  }
  void refuses(const std::string& what, const fs::path& results, const fs::path& named, int code) {
    // The log stands beside the results, where nothing may be writable: it is put elsewhere.
    const fs::path log = fs::path(options_.folder) / "refused";
    fs::remove(log.string() + ".log");
    const int end =
        wait_for(start(options_, log, {}, {"run", options_.study, "--results", results.string(), "-q"}));
    const std::string words = bytes_of(log.string() + ".log");
    fmt::print("{}: ended with {}: {}", what, end, words);
    expect(what + fmt::format(": ended with {}, not {}", end, code), end == code);
    expect(what + ": names the path", words.find(named.string()) != std::string::npos);
  }

  const Options& options_;
  const Undisturbed& expected_;
  int asked_ = 0, good_ = 0;
};

}  // namespace

int lock_folders(const Options& options, const Undisturbed& expected) {
  return ReadOnly(options, expected).run();
}

}  // namespace mpmstudy::faults
