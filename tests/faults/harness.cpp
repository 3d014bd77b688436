#include "tests/faults/harness.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy::faults {

namespace fs = std::filesystem;

pid_t start(const Options& options, const fs::path& results,
            const std::map<std::string, std::string>& environment, std::vector<std::string> words) {
  if (words.empty()) words = {"run", options.study, "--results", results.string(), "-j", "2", "-q"};
  words.insert(words.begin(), options.program);
  return start_words(std::move(words), environment, -1, results.string() + ".log");
}

pid_t start_words(std::vector<std::string> words, const std::map<std::string, std::string>& environment,
                  int output, const std::string& errors) {
  const pid_t child = fork();
  if (child != 0) return child;
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  const int log = open(errors.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  dup2(output >= 0 ? output : log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

int wait_for(pid_t child) {
  int end = 0;
  waitpid(child, &end, 0);
  return WIFEXITED(end) ? WEXITSTATUS(end) : 1000 + WTERMSIG(end);
}

std::string words_of(const fs::path& results) {
  std::stringstream text;
  text << std::ifstream(results.string() + ".log").rdbuf();
  return text.str();
}

Undisturbed run_undisturbed(const Options& options) {
  const fs::path calm = fs::path(options.folder) / "undisturbed";
  const auto begin = std::chrono::steady_clock::now();
  if (const int end = wait_for(start(options, calm)); end != 0)
    throw std::runtime_error(fmt::format("the undisturbed run ended with {}: {}", end, words_of(calm)));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return {rows_of(calm), files_of(calm), seconds.count()};
}

bool same_end(const fs::path& results, const Undisturbed& expected) {
  return rows_of(results) == expected.rows && files_of(results) == expected.files;
}

std::set<std::string> files_of(const fs::path& results) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(results))
    if (const auto path = fs::relative(entry.path(), results).string(); !path.starts_with("catalog.db"))
      files.insert(path);
  return files;
}

namespace {

std::int64_t number(const fs::path& results, const std::string& sql) {
  return std::get<std::int64_t>(query(results, sql).rows.at(0).at(0));
}

}  // namespace

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

}  // namespace mpmstudy::faults
