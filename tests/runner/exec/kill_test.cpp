// SIGKILL at any moment, then again: nothing done is lost or run twice.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <random>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/exec/run_studies.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

constexpr int jobs = 12;

RunReport run(const std::filesystem::path& results) {
  CatalogWriter writer(results);
  Status status;
  StopFlag flag;
  const PlannedStudy study{fakes::plan(jobs), "A fake", {}};
  const Simulate simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    return fakes::simulate(s, o, std::chrono::milliseconds(3));
  };
  ExecutorOptions options;
  options.results = results;
  options.workers = 2;
  return run_studies(std::span(&study, 1), false, writer, status, simulate, fakes::write_snapshot, flag,
                     options);
}

std::int64_t count(const std::filesystem::path& results, const std::string& what) {
  return std::get<std::int64_t>(query(results, "SELECT count(*) FROM " + what).rows[0][0]);
}

TEST(Kill, nothing_done_is_lost_or_run_twice) {
  const fakes::TemporaryFolder folder;
  const auto results = folder.path() / "results";
  std::mt19937 random(7);
  int killed = 0;
  std::int64_t done = 0;
  for (int attempt = 0; attempt < 200 && done < jobs; ++attempt) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      try {
        run(results);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        _exit(99);
      }
      _exit(0);
    }
    usleep(std::uniform_int_distribution<useconds_t>(0, 90'000)(random));
    kill(child, SIGKILL);
    int end = 0;
    waitpid(child, &end, 0);
    ASSERT_FALSE(WIFEXITED(end) && WEXITSTATUS(end) != 0) << WEXITSTATUS(end);
    killed += WIFSIGNALED(end);
    if (!std::filesystem::exists(catalog_path(results))) continue;
    try {
      const auto now = count(results, "jobs WHERE status = 'done'");
      EXPECT_GE(now, done);
      done = now;
    } catch (const std::exception&) {
      EXPECT_EQ(done, 0);  // killed before the catalog was made
    }
  }
  EXPECT_GT(killed, 3);
  EXPECT_EQ(run(results).exit_code(), 0);
  EXPECT_EQ(count(results, "jobs WHERE status = 'done'"), jobs);
  EXPECT_EQ(count(results, "events WHERE to_status = 'done'"), jobs);
  EXPECT_EQ(count(results, "events WHERE from_status = 'done'"), 0);
  EXPECT_EQ(count(results, "area_history"), 50 * jobs);
  EXPECT_EQ(count(results, "snapshots"), 2 * jobs);
  for (const auto& row : query(results, "SELECT path, checksum FROM snapshots").rows)
    EXPECT_EQ(checksum_of(results / std::get<std::string>(row[0])), std::get<std::string>(row[1]));
}

}  // namespace
}  // namespace mpmstudy
