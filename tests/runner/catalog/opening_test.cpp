// Opening: what is made, what is refused and left as it is.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/file_system.hpp"
#include "runner/catalog/reader.hpp"
#include "tests/runner/catalog/opening.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(Opening, makes_folder_and_catalog) {
  const auto db = open_for_writing(results);
  EXPECT_EQ(integer(*db, "PRAGMA user_version"), current_catalog_schema().version());
  EXPECT_EQ(integer(*db, "PRAGMA page_size"), 16384);
  EXPECT_EQ(integer(*db, "PRAGMA application_id"), catalog_application_id);
  EXPECT_EQ(db->execAndGet("PRAGMA journal_mode").getString(), "wal");
  EXPECT_EQ(integer(*db,
                    "SELECT count(*) FROM pragma_table_list WHERE type = 'table' AND strict = 0 "
                    "AND schema = 'main' AND name NOT LIKE 'sqlite%'"),
            0);
  EXPECT_EQ(db->execAndGet("PRAGMA integrity_check").getString(), "ok");
}

TEST_F(Opening, makes_no_backup_of_what_is_current) {
  open_for_writing(results);
  open_for_writing(results);
  for (const auto& entry : fs::directory_iterator(results))
    EXPECT_THAT(entry.path().string(), Not(HasSubstr("backup")));
}

TEST_F(Opening, a_newer_catalog_is_refused_and_left_as_it_is) {
  auto next = current_catalog_schema();
  next.migrations.push_back({version + 1, "CREATE TABLE later (a INTEGER) STRICT;"});
  open_for_writing(results, next);
  const auto before = bytes_of(path);
  for (const auto& message :
       {message_of([&] { open_for_writing(results); }), message_of([&] { open_for_reading(results); })}) {
    EXPECT_THAT(message, HasSubstr(path.string()));
    EXPECT_THAT(message, HasSubstr("newer mpmstudy (catalog version " + std::to_string(version + 1) +
                                   ", this program knows up to " + std::to_string(version) + ")"));
  }
  EXPECT_EQ(bytes_of(path), before);
}

TEST_F(Opening, a_database_of_another_program_is_refused_and_left_as_it_is) {
  fs::create_directories(results);
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE t (a)");
  const auto before = bytes_of(path);
  EXPECT_THAT(message_of([&] { open_for_writing(results); }), HasSubstr("database of another program"));
  EXPECT_THAT(message_of([&] { open_for_reading(results); }), HasSubstr("database of another program"));
  EXPECT_EQ(bytes_of(path), before);
}

TEST_F(Opening, a_file_that_is_no_database_is_refused_and_left_as_it_is) {
  fs::create_directories(results);
  const std::string text(5000, 'x');
  std::ofstream(path) << text;
  EXPECT_THAT(message_of([&] { open_for_writing(results); }), HasSubstr("not a SQLite database"));
  EXPECT_THAT(message_of([&] { open_for_reading(results); }), HasSubstr("not a SQLite database"));
  EXPECT_EQ(bytes_of(path), text);
}

TEST_F(Opening, a_results_folder_that_cannot_be_is_refused) {
  std::ofstream(folder.path() / "file") << "x";
  for (const char* name : {"file", "file/results"})
    EXPECT_THAT(message_of([&] { open_for_writing(folder.path() / name); }),
                AllOf(HasSubstr(name), HasSubstr("results folder"), HasSubstr("--results")));
}

TEST_F(Opening, a_folder_in_the_place_of_the_catalog_is_refused) {
  fs::create_directories(path);
  EXPECT_THAT(message_of([&] { open_for_writing(results); }), HasSubstr("cannot be opened"));
}

TEST_F(Opening, the_umask_decides_who_may_use_the_files) {
  for (const auto& [mask, mode] : {std::pair{0002, 0664}, {0077, 0600}, {0022, 0644}}) {
    const auto here = folder.path() / std::to_string(mask);
    const auto old = umask(static_cast<mode_t>(mask));
    auto next = current_catalog_schema();
    next.migrations.push_back({version + 1, "CREATE TABLE later (a INTEGER) STRICT;"});
    open_for_writing(here);
    const auto db = open_for_writing(here, next);  // with a copy of the file before
    db->exec("INSERT INTO later VALUES (1)");
    umask(old);
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(here)) {
      EXPECT_EQ(static_cast<int>(entry.status().permissions()), mode) << entry.path();
      ++files;
    }
    EXPECT_EQ(files, 4u);  // catalog.db, its log, the log's index, the copy
  }
}

TEST_F(Opening, what_cannot_be_opened_is_named_with_its_owner_and_mode) {
  fs::create_directories(results);
  fs::create_symlink(folder.path() / "nowhere" / "catalog.db", path);
  fs::permissions(results, fs::perms(0750));
  const auto message = message_of([&] { open_for_writing(results); });
  EXPECT_THAT(message, HasSubstr("cannot be opened"));
  EXPECT_THAT(message, HasSubstr("mode 0750"));
  EXPECT_THAT(message, HasSubstr("(" + std::to_string(geteuid()) + ")"));
}

TEST_F(Opening, file_systems_are_known_by_their_numbers) {
  EXPECT_EQ(file_system_with(0x6969).name, "NFS");
  for (const long shared : {0x6969L, 0x0BD00BD0L, 0xFF534D42L,
                            static_cast<long>(static_cast<int>(0xFF534D42)), 0x65735546L, 0x47504653L}) {
    EXPECT_TRUE(file_system_with(shared).shared) << std::hex << shared;
    EXPECT_FALSE(file_system_with(shared).local) << std::hex << shared;
  }
  for (const long local : {0xEF53L, 0x58465342L, 0x9123683EL, 0x01021994L, 0x794C7630L, 0x2FC12FC1L})
    EXPECT_TRUE(file_system_with(local).local && !file_system_with(local).shared) << std::hex << local;
  EXPECT_FALSE(file_system_with(0x12345).shared || file_system_with(0x12345).local);
}

TEST_F(Opening, many_at_once_make_one_catalog) {
  std::atomic<int> opened = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      EXPECT_NO_THROW(open_for_writing(results));
      ++opened;
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(opened, 8);
  EXPECT_EQ(integer(*open_for_reading(results), "PRAGMA user_version"), version);
  for (const auto& entry : fs::directory_iterator(results))
    EXPECT_THAT(entry.path().string(), Not(HasSubstr("backup")));
}

TEST_F(Opening, a_catalog_that_was_being_made_when_the_process_was_killed_is_finished_by_the_next) {
  fs::create_directories(results);
  const pid_t child = fork();
  if (child == 0) {  // dies in its first transaction, when a page of it is on disk
    SQLite::Database db(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db.exec("PRAGMA cache_size = 1; BEGIN IMMEDIATE; CREATE TABLE t (a)");
    for (int i = 0; i < 100; ++i) db.exec("INSERT INTO t VALUES (randomblob(4000))");
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::exists(path.string() + "-journal"));
  EXPECT_FALSE(has_catalog(results));
  EXPECT_THROW(open_for_reading(results), UnfinishedCatalog);
  EXPECT_TRUE(measured_costs(results).empty());  // the first that `run` asks
  EXPECT_EQ(integer(*open_for_writing(results), "PRAGMA user_version"), version);
}

TEST_F(Opening, a_file_that_another_process_is_about_to_fill_is_no_catalog_yet) {
  EXPECT_FALSE(has_catalog(results));
  fs::create_directories(results);
  std::ofstream{path};
  EXPECT_FALSE(has_catalog(results));
  EXPECT_TRUE(measured_costs(results).empty());
  open_for_writing(results);
  EXPECT_TRUE(has_catalog(results));
}

TEST_F(Opening, reading_needs_a_catalog) {
  EXPECT_THAT(message_of([&] { open_for_reading(results); }), HasSubstr("there is no catalog"));
  EXPECT_FALSE(fs::exists(results));
}

TEST_F(Opening, every_parameter_has_a_typed_column) {
  const auto db = open_for_writing(results);
  for (const auto& quantity : mpm::quantities())
    EXPECT_EQ(db->execAndGet("SELECT type FROM pragma_table_info('jobs') WHERE name = '" +
                             std::string(quantity.column) + "'")
                  .getString(),
              "REAL");
  for (const auto& choice : mpm::choices())
    EXPECT_EQ(db->execAndGet("SELECT type FROM pragma_table_info('jobs') WHERE name = '" +
                             std::string(choice.column) + "'")
                  .getString(),
              "TEXT");
}

}  // namespace
}  // namespace mpmstudy
