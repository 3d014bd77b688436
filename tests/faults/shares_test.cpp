// Results on file systems that are not this machine's alone, that give no locks, or that several users share:
// the program under other_machine.c, which has the system answer as such a file system does.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* nfs = "0x6969";

class Shares : public Program {
 protected:
  using Environment = std::map<std::string, std::string>;

  pid_t start_with(Environment environment, const Arguments& arguments) {
    environment["LD_PRELOAD"] = OTHER_MACHINE;
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    const pid_t child = start(arguments);
    for (const auto& [name, value] : environment) unsetenv(name.c_str());
    return child;
  }
  int run_with(Environment environment, const Arguments& arguments) {
    return wait_for(start_with(std::move(environment), arguments));
  }
  int run_smoke(Environment environment) {
    return run_with(std::move(environment), {"run", smoke, "--results", results, "-q"});
  }
  std::string journal_mode() {
    SQLite::Database db(catalog_path(results).string(), SQLite::OPEN_READONLY);
    return db.execAndGet("PRAGMA journal_mode").getString();
  }
  std::string log_now() {
    std::stringstream text;
    text << std::ifstream(log).rdbuf();
    return text.str();
  }
  template <class Condition>
  bool comes_true(Condition condition) {
    for (int i = 0; i < 6000 && !condition(); ++i) usleep(10'000);
    return condition();
  }
};

TEST_F(Shares, on_a_network_file_system_the_catalog_has_a_rollback_journal) {
  for (const auto& [magic, name] : Environment{{nfs, "NFS"}, {"0x0BD00BD0", "Lustre"}}) {
    ASSERT_EQ(run_smoke({{"FAKE_FILE_SYSTEM", magic}}), 0) << output;
    const auto note = output.find("network file system (" + name + ")");
    ASSERT_NE(note, std::string::npos) << output;
    EXPECT_EQ(output.find("network file system", note + 1), std::string::npos) << "named once: " << output;
    EXPECT_EQ(journal_mode(), "delete");
  }
  EXPECT_EQ(query(results, "SELECT key FROM jobs WHERE status = 'done'").rows.size(), 2u);
}

TEST_F(Shares, a_catalog_that_moves_changes_its_journal) {
  ASSERT_EQ(run_smoke({}), 0) << output;
  EXPECT_THAT(output, Not(HasSubstr("network file system")));
  EXPECT_EQ(journal_mode(), "wal");
  ASSERT_EQ(run_smoke({{"FAKE_FILE_SYSTEM", nfs}}), 0) << output;
  EXPECT_EQ(journal_mode(), "delete");
  ASSERT_EQ(run_smoke({}), 0) << output;
  EXPECT_EQ(journal_mode(), "wal");
}

TEST_F(Shares, two_runs_share_the_jobs_there_too) {
  const Environment share = {{"FAKE_FILE_SYSTEM", nfs}};
  const Arguments words = {"run", smoke, "--results", results, "-j", "1"};
  const pid_t one = start_with(share, words), two = start_with(share, words);
  EXPECT_EQ(wait_for(one), 0) << output;
  EXPECT_EQ(wait_for(two), 0) << output;
  EXPECT_EQ(query(results, "SELECT key FROM events WHERE to_status = 'done'").rows.size(), 2u);
}

TEST_F(Shares, without_locks_nothing_is_written_and_the_reason_is_said) {
  for (const auto& [number, reason] :
       Environment{{"37", "No locks available"}, {"524", "Operation not supported"}}) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(run_smoke({{"FAKE_FILE_SYSTEM", nfs}, {"FAKE_LOCK_ERRNO", number}}), 2) << output;
    EXPECT_THAT(output, HasSubstr("its file system (NFS) gives no file locks (" + reason));
    EXPECT_THAT(output, HasSubstr("choose a local folder with --results"));
    EXPECT_THAT(output, Not(HasSubstr("another process")));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20)) << "it waits for a lock";
  }
}

TEST_F(Shares, without_locks_the_catalog_is_read) {
  ASSERT_EQ(run_smoke({}), 0) << output;
  for (const char* number : {"37", "524"}) {
    const Environment none = {{"FAKE_LOCK_ERRNO", number}, {"FAKE_FLOCK_ERRNO", number}};
    EXPECT_EQ(run_with(none, {"status", "--results", results}), 0) << output;
    EXPECT_EQ(run_with(none, {"query", "SELECT count(*) FROM jobs", "--results", results}), 0) << output;
    EXPECT_THAT(output, HasSubstr("2"));
    EXPECT_EQ(run_with(none, {"export", "--what", "jobs", "--results", results}), 0) << output;
  }
}

TEST_F(Shares, a_long_job_goes_on_where_flock_is_refused_and_says_why_it_begins_anew) {
  const Arguments words = {"run",   smoke,   "--results",         results, "-j",
                           "2",     "--set", "cell_size=0.03 um", "-v",    "--checkpoint",
                           "0.05 s"};
  const auto checkpoint = [&]() -> fs::path {
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(results + "/fields", none))
      if (entry.path().filename() == "checkpoint.h5") return entry.path();
    return {};
  };
  const auto stop = [&](pid_t child) {
    kill(child, SIGTERM);
    EXPECT_EQ(wait_for(child), 75) << output;
  };
  const auto forget_log = [&] {
    fs::remove(log);
  };  // or the words of the run before are taken for this one's
  pid_t child = start(words);
  ASSERT_TRUE(comes_true([&] { return !checkpoint().empty(); }));
  stop(child);
  const auto shows_progress = [&] { return log_now().find(" %, step") != std::string::npos; };
  forget_log();
  child = start_with({{"FAKE_FLOCK_ERRNO", "524"}}, words);
  ASSERT_TRUE(comes_true(shows_progress)) << log_now();
  stop(child);
  EXPECT_THAT(output, Not(HasSubstr("begins anew")));
  const fs::path cut = checkpoint();
  ASSERT_FALSE(cut.empty());
  fs::resize_file(cut, 1000);
  forget_log();
  child = start(words);
  ASSERT_TRUE(comes_true(shows_progress)) << log_now();
  stop(child);
  EXPECT_THAT(output, HasSubstr(" begins anew: its checkpoint cannot be read: " + cut.string()));
}

TEST_F(Shares, files_have_the_modes_that_the_umask_gives) {
  const auto old = umask(002);
  const auto mode_of = [](const fs::path& path) {
    struct stat s {};
    EXPECT_EQ(stat(path.c_str(), &s), 0) << path;
    return s.st_mode & 0777;
  };
  const pid_t child = start({"run", smoke, "--results", results, "-j", "2", "--set", "cell_size=0.03 um",
                             "--set", "snapshots=[\"0.1 ns\"]", "--checkpoint", "0.05 s"});
  umask(old);
  const auto count_files = [&] {
    int files = 0;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(results + "/fields", none))
      files += entry.path().extension() == ".h5" || entry.path().extension() == ".vtkhdf";
    return files;
  };
  EXPECT_TRUE(comes_true([&] { return count_files() >= 2; }));
  for (const char* name : {"catalog.db", "catalog.db-wal", "catalog.db-shm"})
    EXPECT_EQ(mode_of(fs::path(results) / name), 0664) << name;
  kill(child, SIGTERM);
  EXPECT_EQ(wait_for(child), 75) << output;
  for (const auto& entry : fs::recursive_directory_iterator(results))
    EXPECT_EQ(mode_of(entry.path()), entry.is_directory() ? 0775u : 0664u) << entry.path();
}

}  // namespace
}  // namespace mpmstudy
