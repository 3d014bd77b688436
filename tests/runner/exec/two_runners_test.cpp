// Two runners at once on one catalog, and readers beside them: the jobs are shared, each is run once, and
// nobody waits for a reader nor a reader for anybody.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/exec/run_studies.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

constexpr int jobs = 60;

/// In a process of its own. Ends with 0 if all jobs are decided and it has run some of them itself.
pid_t start_runner(const std::filesystem::path& results) {
  const pid_t child = fork();
  if (child != 0) return child;
  int code = 99;
  try {
    CatalogWriter writer(results);
    Status status;
    StopFlag flag;
    const PlannedStudy study{fakes::plan(jobs), "A fake", {}};
    const Simulate simulate = [](const mpm::Scene& s, mpm::Observer& o) {
      return fakes::simulate(s, o, std::chrono::milliseconds(10));
    };
    ExecutorOptions options;
    options.results = results;
    options.workers = 2;
    const RunReport report = run_studies(std::span(&study, 1), false, writer, status, simulate,
                                         fakes::write_snapshot, flag, options);
    code = report.exit_code() == 0 && report.executed.done > 0 ? 0 : 98;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  std::_Exit(code);
}

bool has_ended(pid_t child, int& code) {
  int end = 0;
  if (waitpid(child, &end, WNOHANG) != child) return false;
  code = WIFEXITED(end) ? WEXITSTATUS(end) : 1000 + WTERMSIG(end);
  return true;
}

std::int64_t number(const std::filesystem::path& results, const std::string& sql) {
  return std::get<std::int64_t>(query(results, sql).rows.at(0).at(0));
}

class TwoRunners : public testing::Test {
 protected:
  TwoRunners() { CatalogWriter(results).register_study("fake", "A fake", fakes::plan(jobs).jobs, false); }

  /// Calls `meanwhile` again and again until both have ended.
  void run_both(const std::function<void()>& meanwhile) {
    const pid_t children[] = {start_runner(results), start_runner(results)};
    int codes[] = {-1, -1};
    while (codes[0] < 0 || codes[1] < 0) {
      for (int i = 0; i < 2; ++i)
        if (codes[i] < 0) has_ended(children[i], codes[i]);
      meanwhile();
    }
    EXPECT_EQ(codes[0], 0);
    EXPECT_EQ(codes[1], 0);
  }

  fakes::TemporaryFolder folder;
  const std::filesystem::path results = folder.path() / "results";
};

TEST_F(TwoRunners, share_the_work_and_do_nothing_twice) {
  run_both([] { usleep(10'000); });
  EXPECT_EQ(number(results, "SELECT count(*) FROM jobs WHERE status = 'done'"), jobs);
  EXPECT_EQ(number(results, "SELECT count(*) FROM events WHERE to_status = 'running'"), jobs);
  EXPECT_EQ(number(results, "SELECT count(*) FROM events WHERE to_status = 'done'"), jobs);
  EXPECT_EQ(number(results, "SELECT count(DISTINCT \"by\") FROM events WHERE to_status = 'done'"), 2);
}

TEST_F(TwoRunners, are_not_in_the_way_of_readers) {
  using Clock = std::chrono::steady_clock;
  int asked = 0;
  std::int64_t done = 0;
  Clock::duration longest{};
  run_both([&] {
    const auto begin = Clock::now();
    const auto now = read_state(results).studies.at(0).jobs[JobStatus::done];
    EXPECT_GE(now, done) << "a reader sees one moment after the other";
    done = now;
    query(results, "SELECT * FROM jobs");
    query(results, "SELECT * FROM events");
    longest = std::max(longest, Clock::now() - begin);
    ++asked;
  });
  EXPECT_GT(asked, 3);
  // A reader that had to wait for a writer would wait for its busy timeout.
  EXPECT_LT(std::chrono::duration<double>(longest).count(), 5);
}

TEST_F(TwoRunners, do_not_wait_for_a_reader_that_never_ends) {
  // Opened when the runners have been forked: an SQLite connection must not be used after a fork.
  std::optional<SQLite::Database> db;
  std::optional<SQLite::Statement> reading;
  run_both([&] {
    if (!db) {
      db.emplace(catalog_path(results).string(), SQLite::OPEN_READONLY);
      reading.emplace(*db, "SELECT key FROM jobs");
      ASSERT_TRUE(reading->executeStep());  // and never goes on
    }
    usleep(10'000);
  });
  ASSERT_TRUE(reading->executeStep());
  EXPECT_EQ(number(results, "SELECT count(*) FROM jobs WHERE status = 'done'"), jobs);
}

}  // namespace
}  // namespace mpmstudy
