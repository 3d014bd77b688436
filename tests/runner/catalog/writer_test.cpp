// The writer: whole rows, exact bits, true states, readers at the same time.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <csignal>
#include <fstream>
#include <optional>
#include <thread>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/runner/catalog/writer.hpp"

namespace mpmstudy {
namespace {

/// Older programs made the spall strength part of every key, also where nothing reads it.
TEST_F(Writer, a_job_filed_under_its_former_key_is_found) {
  CatalogWriter writer(folder.path());
  mpm::Scene scene = fakes::scene(1e-6);
  scene.material.spall_strength = 1e9;
  const Job before{former_key(scene), scene, {1000, 200}, 1}, now{job_key(scene), scene, {1000, 200}, 1};
  ASSERT_NE(before.key, now.key);
  writer.register_study("s", "S", {before}, false);
  EXPECT_TRUE(writer.reserve(before.key));
  const auto file = folder.path() / finished(before).snapshots[0].path;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << "ten bytes!";
  writer.complete(finished(before));
  writer.flush();
  const auto again = writer.register_study("s", "S", {now}, false);
  EXPECT_EQ(again.done, 1);
  EXPECT_TRUE(again.to_run.empty());
  EXPECT_EQ(one("SELECT key FROM jobs"), SqlValue(now.key));
  EXPECT_EQ(count("events WHERE reason LIKE 'its key was " + before.key + "%'"), 1);
  // Files stay, and the job is found by both keys.
  writer.sweep_files();
  EXPECT_TRUE(std::filesystem::exists(file));
  for (const std::string& key : {before.key, now.key}) {
    const auto found = read_jobs(folder.path(), {key.substr(0, 12), ""});
    ASSERT_EQ(found.size(), 1u) << key;
    EXPECT_EQ(found[0].job.key, now.key);
  }
  EXPECT_EQ(writer.register_study("s", "S", {now}, false).done, 1);
}

TEST_F(Writer, one_that_was_only_planned_runs_under_the_new_key) {
  CatalogWriter writer(folder.path());
  mpm::Scene scene = fakes::scene(1e-6);
  scene.material.spall_strength = 1e9;
  const Job before{former_key(scene), scene, {1000, 200}, 1}, now{job_key(scene), scene, {1000, 200}, 1};
  writer.register_study("s", "S", {before}, false);
  EXPECT_EQ(writer.register_study("s", "S", {now}, false).to_run, std::vector{now.key});
  EXPECT_TRUE(writer.reserve(now.key));
  EXPECT_EQ(count("jobs"), 1);
}

TEST_F(Writer, a_job_goes_from_planned_to_done_once) {
  CatalogWriter writer(folder.path());
  const auto plan = fakes::plan(2);
  const auto registration = writer.register_study("s", "S", plan.jobs, false);
  EXPECT_EQ(registration.to_run, (std::vector{fakes::key(1), fakes::key(2)}));
  EXPECT_TRUE(writer.reserve(fakes::key(1)));
  EXPECT_FALSE(writer.reserve(fakes::key(1)));
  std::filesystem::create_directories(folder.path() / "fields" / fakes::key(1));
  std::ofstream(folder.path() / finished(plan.jobs[0]).snapshots[0].path) << "ten bytes!";
  writer.complete(finished(plan.jobs[0]));
  writer.flush();
  EXPECT_EQ(count("jobs WHERE status = 'done' AND wall_s = 1.5 AND cpu_s = 1.25"), 1);
  EXPECT_EQ(count("metrics"), 2);
  EXPECT_EQ(count("area_history"), 50);
  EXPECT_EQ(count("history WHERE name = 'rear' AND unit = 'm/s'"), 3);
  EXPECT_EQ(std::get<double>(query(folder.path(), "SELECT value FROM history ORDER BY time_s").rows[1][0]),
            1.0 / 3);
  const auto stored = read_jobs(folder.path(), {fakes::key(1), ""});
  ASSERT_EQ(stored.size(), 1u);
  EXPECT_EQ(stored[0].job.scene.measures.gauges, plan.jobs[0].scene.measures.gauges);
  EXPECT_EQ(count("snapshots"), 1);
  EXPECT_EQ(count("events WHERE key LIKE '%1'"), 3);
  const auto again = writer.register_study("s", "S", plan.jobs, false);
  EXPECT_EQ(again.done, 1);
  EXPECT_EQ(again.to_run, (std::vector{fakes::key(2)}));
}

TEST_F(Writer, doubles_keep_their_bits) {
  CatalogWriter writer(folder.path());
  auto job = fakes::job(1);
  job.scene.cavity_radius = std::nextafter(1e-6, 1);
  writer.register_study("s", "S", {job}, false);
  ASSERT_TRUE(writer.reserve(job.key));
  auto f = finished(job);
  const double odd[] = {0.1 + 0.2, 5e-324, -1.7976931348623157e308, 1.0 / 3, INFINITY, 3.0, 1e300 / 7};
  f.result.metrics.clear();
  for (std::size_t i = 0; i < std::size(odd); ++i)
    f.result.metrics.push_back({"m" + std::to_string(i), odd[i], "1", {}});
  f.result.metrics.push_back({"m9", NAN, "1", {}});
  writer.complete(f);
  writer.flush();
  const auto rows = query(folder.path(), "SELECT value FROM metrics ORDER BY name").rows;
  for (std::size_t i = 0; i < std::size(odd); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::get<double>(rows[i][0])),
              std::bit_cast<std::uint64_t>(odd[i]));
  EXPECT_EQ(rows.back()[0], SqlValue());  // not a number: null
  EXPECT_EQ(read_jobs(folder.path()).at(0).job.scene.cavity_radius, job.scene.cavity_radius);
  EXPECT_EQ(one("SELECT cavity_radius_m FROM jobs"), SqlValue(1e-6)) << "as it would be written";
}

TEST_F(Writer, studies_share_jobs) {
  CatalogWriter writer(folder.path());
  writer.register_study("a", "A", fakes::plan(3).jobs, false);
  writer.register_study("b", "B", fakes::plan(2).jobs, false);
  EXPECT_EQ(count("jobs"), 5);
  EXPECT_EQ(count("(SELECT DISTINCT key FROM jobs)"), 3);
  // a no longer has job 2 and 3: 2 stays planned for b, 3 is nobody's.
  writer.register_study("a", "A", fakes::plan(1).jobs, false);
  EXPECT_EQ(one("SELECT status FROM jobs WHERE key LIKE '%2'"), SqlValue("planned"));
  EXPECT_EQ(one("SELECT status FROM jobs WHERE key LIKE '%3'"), SqlValue("cancelled"));
  EXPECT_EQ(one("SELECT study FROM jobs WHERE key LIKE '%3'"), SqlValue());
  EXPECT_EQ(writer.register_study("a", "A", fakes::plan(3).jobs, false).to_run.size(), 3u);
}

TEST_F(Writer, failed_jobs_are_left_unless_told) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(1).jobs;
  writer.register_study("s", "S", jobs, false);
  writer.reserve(jobs[0].key);
  auto f = finished(jobs[0]);
  f.status = JobStatus::failed;
  f.reason = "step 7: particle 3 has no volume";
  writer.complete(f);
  EXPECT_EQ(writer.register_study("s", "S", jobs, false).failed, 1);
  const auto state = read_state(folder.path());
  ASSERT_EQ(state.failed.size(), 1u);
  EXPECT_EQ(state.failed[0].reason, f.reason);
  EXPECT_EQ(writer.register_study("s", "S", jobs, true).to_run.size(), 1u);
  EXPECT_TRUE(writer.reserve(jobs[0].key));
  EXPECT_EQ(one("SELECT attempt FROM jobs"), SqlValue(std::int64_t{2}));
}

TEST_F(Writer, a_second_result_replaces_the_first_attempts) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(1).jobs;
  writer.register_study("s", "S", jobs, false);
  for (const auto status : {JobStatus::failed, JobStatus::done}) {
    ASSERT_TRUE(writer.reserve(jobs[0].key));
    auto f = finished(jobs[0]);
    f.status = status;
    writer.complete(f);
    writer.register_study("s", "S", jobs, true);
  }
  EXPECT_EQ(count("area_history"), 50);
  EXPECT_EQ(count("metrics"), 2);
}

TEST_F(Writer, a_result_of_a_job_that_is_not_ours_is_an_error) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(1).jobs;
  writer.register_study("s", "S", jobs, false);
  EXPECT_THROW(writer.complete(finished(jobs[0])), CatalogError);  // never reserved
  EXPECT_EQ(count("jobs WHERE status = 'planned'"), 1);
  EXPECT_EQ(count("metrics"), 0);
}

TEST_F(Writer, two_writers_never_reserve_the_same_job) {
  CatalogWriter a(folder.path()), b(folder.path());
  const auto jobs = fakes::plan(50).jobs;
  a.register_study("s", "S", jobs, false);
  std::atomic<int> reserved = 0;
  std::thread other([&] {
    for (const auto& job : jobs) reserved += b.reserve(job.key).mine;
  });
  for (const auto& job : jobs) reserved += a.reserve(job.key).mine;
  other.join();
  EXPECT_EQ(reserved, 50);
  EXPECT_EQ(a.register_study("s", "S", jobs, false).running_elsewhere, 50);
}

TEST_F(Writer, jobs_of_a_process_that_is_gone_are_planned_again) {
  const auto jobs = fakes::plan(1).jobs;
  WriterOptions dead;
  dead.store.process.pid = 1;  // lives, but began at another time
  CatalogWriter zombie(folder.path(), dead);
  zombie.register_study("s", "S", jobs, false);
  ASSERT_TRUE(zombie.reserve(jobs[0].key));
  CatalogWriter writer(folder.path());
  const auto registration = writer.register_study("s", "S", jobs, false);
  EXPECT_EQ(registration.taken_up, 1);
  EXPECT_EQ(registration.to_run.size(), 1u);
  EXPECT_EQ(count("events WHERE from_status = 'running' AND to_status = 'planned' AND reason LIKE '%gone%'"),
            1);
  EXPECT_FALSE(zombie.holds(jobs[0].key));
  EXPECT_FALSE(zombie.complete(finished(jobs[0])));  // too late: the job is not its own any longer
  EXPECT_EQ(count("jobs WHERE status = 'planned' AND crashes = 1"), 1);
  EXPECT_EQ(count("metrics"), 0);
}

TEST_F(Writer, reserving_takes_up_a_job_whose_process_is_gone_meanwhile) {
  const auto jobs = fakes::plan(2).jobs;
  WriterOptions options;
  const pid_t child = fork();
  if (child == 0) pause();
  options.store.process.pid = child;  // this process, but for its number and its start
  options.store.process.process_start = process_with(child).process_start;
  CatalogWriter mortal(folder.path(), options);
  mortal.register_study("s", "S", jobs, false);
  ASSERT_TRUE(mortal.reserve(jobs[0].key));
  CatalogWriter writer(folder.path());
  EXPECT_EQ(writer.reserve(jobs[0].key).status, JobStatus::running);
  kill(child, SIGKILL);
  EXPECT_EQ(writer.reserve(jobs[1].key).crashes, 0);
  waitpid(child, nullptr, 0);
  const auto reservation = writer.reserve(jobs[0].key);
  EXPECT_TRUE(reservation);
  EXPECT_EQ(reservation.crashes, 1);
  EXPECT_EQ(count("events WHERE reason LIKE '%gone%'"), 1);
}

TEST_F(Writer, reserving_says_what_the_job_is_that_it_does_not_get) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(1).jobs;
  writer.register_study("s", "S", jobs, false);
  ASSERT_TRUE(writer.reserve(jobs[0].key));
  writer.complete(finished(jobs[0]));
  EXPECT_EQ(writer.reserve(jobs[0].key).status, JobStatus::done);
  EXPECT_FALSE(writer.reserve("unknown"));
}

TEST_F(Writer, the_kind_of_a_failure_is_kept_and_goes_with_it) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(1).jobs;
  writer.register_study("s", "S", jobs, false);
  writer.reserve(jobs[0].key);
  EXPECT_EQ(writer.crashed(jobs[0].key), 1);
  auto f = finished(jobs[0]);
  f.status = JobStatus::failed;
  f.failure = FailureKind::timeout;
  writer.complete(f);
  writer.flush();
  EXPECT_EQ(one("SELECT failure_kind || crashes FROM jobs"), SqlValue("timeout1"));
  writer.register_study("s", "S", jobs, true);
  EXPECT_EQ(one("SELECT failure_kind FROM jobs"), SqlValue());
}

TEST_F(Writer, orphans_are_swept_and_nothing_else) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(3).jobs;
  writer.register_study("s", "S", jobs, false);
  writer.reserve(jobs[0].key);
  writer.reserve(jobs[1].key);
  writer.complete(finished(jobs[0]));
  namespace fs = std::filesystem;
  for (const auto& key : {jobs[0].key, jobs[1].key, jobs[2].key, std::string("nobody")}) {
    fs::create_directories(folder.path() / "fields" / key);
    std::ofstream(folder.path() / "fields" / key / "file.tmp") << "x";
  }
  EXPECT_EQ(writer.sweep_files(), 2);
  EXPECT_TRUE(fs::exists(folder.path() / "fields" / jobs[0].key));   // done
  EXPECT_TRUE(fs::exists(folder.path() / "fields" / jobs[1].key));   // running
  EXPECT_FALSE(fs::exists(folder.path() / "fields" / jobs[2].key));  // planned
}

TEST_F(Writer, a_copy_of_the_file_alone_has_the_rows) {
  const auto jobs_in_copy = [&]() -> std::int64_t {
    fakes::TemporaryFolder copy;
    std::filesystem::copy_file(folder.path() / "catalog.db", copy.path() / "catalog.db");
    try {
      return std::get<std::int64_t>(query(copy.path(), "SELECT count(*) FROM jobs").rows[0][0]);
    } catch (const CatalogError&) {
      return 0;  // not there yet
    }
  };
  WriterOptions options;
  options.heartbeat = options.move_log = std::chrono::milliseconds(10);
  CatalogWriter writer(folder.path(), options);
  writer.register_study("s", "S", fakes::plan(3).jobs, false);
  for (int i = 0; i < 500 && jobs_in_copy() < 3; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(jobs_in_copy(), 3);
}

TEST_F(Writer, at_its_end_the_file_alone_has_the_rows_although_somebody_has_it_open) {
  std::optional<SQLite::Database> reader;
  {
    CatalogWriter writer(folder.path());
    reader.emplace((folder.path() / "catalog.db").string(), SQLite::OPEN_READONLY);
    reader->execAndGet("SELECT count(*) FROM job");  // has the log open from here on
    writer.register_study("s", "S", fakes::plan(3).jobs, false);
  }
  fakes::TemporaryFolder copy;
  std::filesystem::copy_file(folder.path() / "catalog.db", copy.path() / "catalog.db");
  EXPECT_EQ(std::get<std::int64_t>(query(copy.path(), "SELECT count(*) FROM jobs").rows[0][0]), 3);
}

TEST_F(Writer, readers_see_whole_rows_while_it_writes) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(60).jobs;
  writer.register_study("s", "S", jobs, false);
  std::atomic<bool> over = false;
  std::atomic<int> looks = 0;
  std::thread reader([&] {
    while (!over || looks == 0) {
      const auto rows =
          query(folder.path(),
                "SELECT count(*), (SELECT count(*) FROM area_history), (SELECT count(*) FROM metrics), "
                "(SELECT count(*) FROM snapshots) FROM jobs WHERE status = 'done'")
              .rows[0];
      const auto done = std::get<std::int64_t>(rows[0]);
      EXPECT_EQ(std::get<std::int64_t>(rows[1]), 50 * done);
      EXPECT_EQ(std::get<std::int64_t>(rows[2]), 2 * done);
      EXPECT_EQ(std::get<std::int64_t>(rows[3]), done);
      ++looks;
    }
  });
  for (const auto& job : jobs) {
    ASSERT_TRUE(writer.reserve(job.key));
    writer.complete(finished(job));
  }
  writer.flush();
  over = true;
  reader.join();
  EXPECT_EQ(count("jobs WHERE status = 'done'"), 60);
}

TEST_F(Writer, fits_and_brackets_replace_those_before) {
  CatalogWriter writer(folder.path());
  writer.register_study("s", "S", {}, false);
  const FitRow c0{"collapsibility", "cavity_radius", "quadratic", "c0", 0.1, 0.01, 0.99, "1"};
  auto c1 = c0;
  c1.coefficient = "c1";
  c1.standard_error.reset();
  writer.replace_fits("s", {c0, c1});
  writer.replace_fits("s", {c0, c1});
  EXPECT_EQ(count("fits WHERE study = 's' AND against = 'cavity_radius'"), 2);
  EXPECT_EQ(count("fits WHERE standard_error IS NULL"), 1);
  writer.replace_brackets("s", {{"impact_speed", "m/s", 200.0, 210.0, "a", "b", 1e-7}});
  writer.replace_brackets("s", {{"impact_speed", "m/s", 200.0, 205.0, "a", "c", 1e-7, 190, 20, "", 6, 0}});
  EXPECT_EQ(one("SELECT upper_m_s FROM critical_speed"), SqlValue(205.0));
  EXPECT_THROW(writer.replace_fits("unknown", {}), CatalogError);
  writer.flush();  // an answer that was an error does not break the writer
}

TEST_F(Writer, a_large_study_that_is_done_starts_at_once) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(2000).jobs;
  writer.register_study("s", "S", jobs, false);
  const auto start = std::chrono::steady_clock::now();
  writer.register_study("s", "S", jobs, false);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

}  // namespace
}  // namespace mpmstudy
