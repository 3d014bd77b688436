// What `status` reads: who runs what, and whether somebody still does.
#include "runner/catalog/reader.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

class Reader : public testing::Test {
 protected:
  fakes::TemporaryFolder folder;
};

TEST_F(Reader, state_names_who_runs_what) {
  CatalogWriter writer(folder.path());
  const auto jobs = fakes::plan(3).jobs;
  writer.register_study("s", "S", jobs, false);
  writer.reserve(jobs[1].key);
  const auto state = read_state(folder.path(), {"s"});
  ASSERT_EQ(state.studies.size(), 1u);
  EXPECT_EQ(state.studies[0].jobs.at(JobStatus::planned), 2);
  ASSERT_EQ(state.running.size(), 1u);
  EXPECT_EQ(state.running[0].key, jobs[1].key);
  EXPECT_THAT(state.running[0].by, testing::EndsWith(":" + std::to_string(getpid())));
  EXPECT_EQ(state.running[0].gone, "");
  EXPECT_THROW(read_state(folder.path(), {"other"}), CatalogError);
}

TEST_F(Reader, state_says_whose_process_has_gone) {
  WriterOptions killed;
  killed.store.process.process_start -= 1;  // whoever has that number now started later
  CatalogWriter writer(folder.path(), killed);
  const auto jobs = fakes::plan(1).jobs;
  writer.register_study("s", "S", jobs, false);
  writer.reserve(jobs[0].key);
  const auto state = read_state(folder.path());
  ASSERT_EQ(state.running.size(), 1u);
  EXPECT_EQ(state.running[0].gone, "its process has gone");
}

TEST_F(Reader, state_says_when_another_machine_was_last_heard_of) {
  WriterOptions far;
  far.store.process.host = "another-host";
  CatalogWriter writer(folder.path(), far);
  const auto jobs = fakes::plan(1).jobs;
  writer.register_study("s", "S", jobs, false);
  writer.reserve(jobs[0].key);
  EXPECT_EQ(read_state(folder.path()).running.at(0).gone, "");
  EXPECT_NE(read_state(folder.path()).running.at(0).last_sign, "");
  const auto set = [&](const std::string& what) {
    SQLite::Database((folder.path() / "catalog.db").string(), SQLite::OPEN_READWRITE)
        .exec("UPDATE runner SET " + what);
  };
  set("heartbeat_at = '2000-01-01T00:00:00.000Z'");
  // Whose clock is wrong cannot be known from one look.
  EXPECT_EQ(read_state(folder.path()).running.at(0).gone, "");
  EXPECT_EQ(read_state(folder.path()).running.at(0).last_sign, "2000-01-01T00:00:00.000Z");
  set("ended_at = heartbeat_at");
  EXPECT_EQ(read_state(folder.path()).running.at(0).gone, "its process has ended");
}

TEST_F(Reader, a_catalog_of_an_older_program_is_read_as_it_is) {
  {
    CatalogWriter writer(folder.path());
    writer.register_study("s", "S", fakes::plan(1).jobs, false);
    writer.reserve(fakes::key(1));
  }
  SQLite::Database((folder.path() / "catalog.db").string(), SQLite::OPEN_READWRITE)
      .exec(
          "ALTER TABLE runner DROP COLUMN name_space; ALTER TABLE runner DROP COLUMN beats;"
          "ALTER TABLE runner DROP COLUMN expires_s; PRAGMA user_version = 6");
  EXPECT_EQ(read_state(folder.path()).running.size(), 1u);
  try {
    query(folder.path(), "SELECT name_space FROM runner");
    FAIL();
  } catch (const CatalogError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("no such column: name_space; the catalog is of an older mpmstudy"));
  }
}

TEST_F(Reader, state_names_the_study_of_coarser_cells) {
  CatalogWriter writer(folder.path());
  auto jobs = fakes::plan(2).jobs;
  jobs[0].rung_of = 1;
  writer.register_study("s", "S", jobs, false);
  writer.reserve(jobs[0].key);
  const auto state = read_state(folder.path(), {"s"});
  ASSERT_EQ(state.running.size(), 1u);
  EXPECT_EQ(state.running[0].study, "s");
}

}  // namespace
}  // namespace mpmstudy
