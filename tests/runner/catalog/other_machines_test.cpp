// What a writer decides about jobs of others: whose files are damaged, whose process has gone, which runner
// of another machine gives no sign of life.
#include <SQLiteCpp/SQLiteCpp.h>

#include <fstream>
#include <thread>

#include "runner/catalog/field_files.hpp"
#include "runner/catalog/heartbeats.hpp"
#include "runner/catalog/reader.hpp"
#include "tests/runner/catalog/writer.hpp"

namespace mpmstudy {
namespace {

/// Writes a file of fields, and has the job done with it.
class FieldFiles : public Writer {
 protected:
  FieldFiles() {
    writer.register_study("s", "S", jobs, false);
    writer.reserve(jobs[0].key);
    auto f = finished(jobs[0]);
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << "ten bytes!";
    f.snapshots[0].checksum = checksum_of(path);
    f.snapshots[0].modified_ns = modified_ns(path);
    writer.complete(f);
    writer.flush();
  }
  /// Registers again: is the job to run?
  std::int64_t damaged() { return writer.register_study("s", "S", jobs, false).damaged; }

  CatalogWriter writer{folder.path()};
  const std::vector<Job> jobs = fakes::plan(1).jobs;
  const std::filesystem::path path = folder.path() / finished(jobs[0]).snapshots[0].path;
};

TEST_F(FieldFiles, what_is_whole_is_left) { EXPECT_EQ(damaged(), 0); }

TEST_F(FieldFiles, a_missing_file_has_its_job_run_again) {
  std::filesystem::remove(path);
  EXPECT_EQ(damaged(), 1);
  EXPECT_EQ(one("SELECT status FROM jobs"), SqlValue("planned"));
  EXPECT_EQ(count("events WHERE from_status = 'done' AND reason LIKE '%No such file%'"), 1);
}

TEST_F(FieldFiles, a_file_that_is_cut_short_too) {
  std::filesystem::resize_file(path, 4);
  EXPECT_EQ(damaged(), 1);
  EXPECT_EQ(count("events WHERE reason LIKE '%has 4 bytes, was written with 10%'"), 1);
}

TEST_F(FieldFiles, and_one_whose_bytes_were_changed) {
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::ofstream(path) << "ten bytes?";
  EXPECT_EQ(damaged(), 1);
  EXPECT_EQ(count("events WHERE reason LIKE '%checksum%'"), 1);
}

TEST_F(Writer, jobs_of_another_host_are_its_own_while_it_gives_signs_of_life) {
  const auto jobs = fakes::plan(1).jobs;
  WriterOptions far;
  far.store.process.host = "another-host";
  CatalogWriter other(folder.path(), far);
  other.register_study("s", "S", jobs, false);
  ASSERT_TRUE(other.reserve(jobs[0].key));
  CatalogWriter writer(folder.path());
  EXPECT_EQ(writer.register_study("s", "S", jobs, false).running_elsewhere, 1);
}

/// Runners of one folder that can not look for each other: judged by their signs of life alone.
class Machines : public Writer {
 protected:
  static WriterOptions machine(const std::string& host, const std::string& name_space = "pid:[1] ") {
    WriterOptions options;
    options.store.process.host = host;
    options.store.process.name_space = name_space;
    options.store.heartbeat_expires_s = 0.4;
    options.heartbeat = std::chrono::milliseconds(20);
    return options;
  }
  /// A process that has reserved the job, and then gives no sign of life.
  std::unique_ptr<CatalogWriter> silent(WriterOptions options) {
    options.heartbeat = std::chrono::hours(1);
    auto writer = std::make_unique<CatalogWriter>(folder.path(), options);
    writer->register_study("s", "S", jobs, false);
    EXPECT_TRUE(writer->reserve(jobs[0].key));
    return writer;
  }
  /// Asks for the job until `writer` gets it, for so long.
  bool gets_the_job(CatalogWriter& writer, std::chrono::milliseconds time) {
    for (const auto end = std::chrono::steady_clock::now() + time; std::chrono::steady_clock::now() < end;
         std::this_thread::sleep_for(std::chrono::milliseconds(10)))
      if (writer.reserve(jobs[0].key)) return true;
    return false;
  }
  const std::vector<Job> jobs = fakes::plan(1).jobs;
};

TEST_F(FieldFiles, also_by_a_machine_whose_clock_is_behind) {
  std::ofstream(path) << "ten bytes?";
  std::filesystem::last_write_time(path,
                                   std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(damaged(), 1);
}

TEST_F(Machines, a_process_of_another_namespace_is_not_gone_because_its_number_is_unknown_here) {
  auto options = machine(this_process().host);
  options.store.process.pid = 1'000'000'000;  // nobody has it here
  options.store.heartbeat_expires_s = 60;
  const auto other = silent(options);
  CatalogWriter writer(folder.path());
  EXPECT_EQ(writer.register_study("s", "S", jobs, false).running_elsewhere, 1);
  EXPECT_FALSE(writer.reserve(jobs[0].key));
  const auto state = read_state(folder.path());
  EXPECT_EQ(state.running.at(0).gone, "");
  EXPECT_THAT(state.running.at(0).last_sign, testing::HasSubstr("T"));
}

TEST_F(Machines, nor_one_of_another_boot_of_a_host_with_this_name) {
  WriterOptions options;
  options.store.process.boot_id = "another";
  const auto other = silent(options);
  CatalogWriter writer(folder.path());
  EXPECT_EQ(writer.register_study("s", "S", jobs, false).running_elsewhere, 1);
}

TEST_F(Machines, one_that_gives_signs_of_life_keeps_its_job_whatever_the_clocks_say) {
  CatalogWriter other(folder.path(), machine("a"));
  other.register_study("s", "S", jobs, false);
  ASSERT_TRUE(other.reserve(jobs[0].key));
  CatalogWriter writer(folder.path(), machine("b"));
  SQLite::Database db((folder.path() / "catalog.db").string(), SQLite::OPEN_READWRITE, 5000);
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1200);
  for (int i = 0; std::chrono::steady_clock::now() < end; ++i) {
    // Its clock is years behind, ahead, or stands still.
    db.exec(i % 2 ? "UPDATE runner SET heartbeat_at = '2000-01-01T00:00:00.000Z' WHERE host = 'a'"
                  : "UPDATE runner SET heartbeat_at = '2900-01-01T00:00:00.000Z' WHERE host = 'a'");
    ASSERT_FALSE(gets_the_job(writer, std::chrono::milliseconds(50)));
  }
}

TEST_F(Machines, one_that_is_silent_loses_its_job_and_learns_it) {
  const auto other = silent(machine("a"));
  CatalogWriter writer(folder.path(), machine("b"));
  EXPECT_TRUE(gets_the_job(writer, std::chrono::seconds(5)));
  EXPECT_FALSE(other->holds(jobs[0].key));
  EXPECT_FALSE(other->complete(finished(jobs[0])));
  EXPECT_TRUE(writer.complete(finished(jobs[0])));
  EXPECT_EQ(count("events WHERE to_status = 'done'"), 1);
}

TEST_F(Machines, a_runner_is_told_at_its_next_sign_of_life_which_jobs_it_has_lost) {
  CatalogWriter other(folder.path(), machine("a"));
  other.register_study("s", "S", jobs, false);
  ASSERT_TRUE(other.reserve(jobs[0].key));
  EXPECT_FALSE(other.lost(jobs[0].key));
  SQLite::Database((folder.path() / "catalog.db").string(), SQLite::OPEN_READWRITE, 5000)
      .exec("UPDATE job SET status = 'planned', runner_id = NULL");
  for (int i = 0; i < 500 && !other.lost(jobs[0].key); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(other.lost(jobs[0].key));
  EXPECT_TRUE(other.reserve(jobs[0].key));
  EXPECT_FALSE(other.lost(jobs[0].key));
}

TEST(Heartbeats, silence_is_counted_on_ones_own_clock_since_the_sign_last_changed) {
  using namespace std::chrono_literals;
  Heartbeats heartbeats;
  const Heartbeats::Clock::time_point start{};
  EXPECT_EQ(heartbeats.silence(7, "a", 15, start), 0);
  EXPECT_EQ(heartbeats.silence(7, "a", 15, start + 5s), 5);
  EXPECT_EQ(heartbeats.silence(7, "a", 15, start + 10s), 10);
  EXPECT_EQ(heartbeats.silence(7, "b", 15, start + 15s), 0);
  EXPECT_EQ(heartbeats.silence(8, "a", 15, start + 15s), 0);  // another runner
  // This process was stopped, or the share hung: others could not give a sign of life either.
  EXPECT_EQ(heartbeats.silence(7, "b", 15, start + 1000s), 15);
  EXPECT_EQ(heartbeats.silence(7, "b", 15, start + 1001s), 16);
}

}  // namespace
}  // namespace mpmstudy
