// Opening: what is made, what is migrated, what is refused and left as it is.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <sstream>
#include <thread>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/file_system.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const CatalogError& error) {
    return error.what();
  }
  return "no CatalogError";
}

int integer(SQLite::Database& db, const std::string& sql) { return db.execAndGet(sql).getInt(); }

/// A catalog as an older program left it: its tables; the views follow when it is opened.
void make_tables(const fs::path& results, const CatalogSchema& schema) {
  fs::create_directories(results);
  SQLite::Database db(catalog_path(results).string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  for (const auto& migration : schema.migrations) db.exec(std::string(migration.sql));
  db.exec("PRAGMA application_id = " + std::to_string(catalog_application_id));
  db.exec("PRAGMA user_version = " + std::to_string(schema.version()));
}

class Opening : public testing::Test {
 protected:
  fakes::TemporaryFolder folder;
  fs::path results = folder.path() / "results";
  fs::path path = catalog_path(results);
  const int version = current_catalog_schema().version();
  const std::string backup = path.string() + ".v" + std::to_string(version) + ".backup";
};

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

TEST_F(Opening, migrates_an_older_layout_and_keeps_a_copy) {
  open_for_writing(results)->exec(
      "INSERT INTO study (name, title, updated_at) VALUES ('old', 'Old', '2030-01-01T00:00:00.000Z')");
  auto next = current_catalog_schema();
  next.migrations.push_back({version + 1, "CREATE TABLE later (a INTEGER) STRICT;"});
  {
    const auto db = open_for_writing(results, next);
    EXPECT_EQ(integer(*db, "PRAGMA user_version"), version + 1);
    EXPECT_TRUE(db->tableExists("later"));
    EXPECT_EQ(integer(*db, "SELECT count(*) FROM studies WHERE name = 'old'"), 1);
  }
  SQLite::Database copy(backup, SQLite::OPEN_READONLY);
  EXPECT_EQ(integer(copy, "PRAGMA user_version"), version);
  EXPECT_FALSE(copy.tableExists("later"));
  EXPECT_EQ(integer(copy, "SELECT count(*) FROM studies WHERE name = 'old'"), 1);
}

TEST_F(Opening, every_older_layout_becomes_the_current_one) {
  const auto newest = current_catalog_schema();
  const auto layout = [](const fs::path& of) {
    const auto db = open_for_writing(of);
    std::string text;
    SQLite::Statement rows(*db,
                           "SELECT m.name || '.' || c.name || ' ' || c.type FROM sqlite_schema m "
                           "JOIN pragma_table_info(m.name) c ORDER BY m.name, c.name");
    while (rows.executeStep()) text += rows.getColumn(0).getString() + "\n";
    return text;
  };
  const auto expected = layout(folder.path() / "new");
  for (std::size_t kept = 1; kept < newest.migrations.size(); ++kept) {
    auto older = newest;
    older.migrations.resize(kept);
    const auto here = folder.path() / std::to_string(kept);
    ASSERT_NO_THROW(make_tables(here, older)) << kept;
    EXPECT_EQ(layout(here), expected) << kept;
  }
}

TEST_F(Opening, parameters_of_an_older_layout_move_into_their_jobs) {
  auto older = current_catalog_schema();
  older.migrations.resize(5);
  make_tables(results, older);
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
      .exec(
          "ALTER TABLE job_parameters ADD COLUMN gone_since REAL;"
          "ALTER TABLE job_parameters ADD COLUMN kernel TEXT;"
          "INSERT INTO job (id, key, scene, material, snapshot_times, physics_version, predicted_particles, "
          "predicted_steps, status) VALUES (7, 'k', 'cavity-impact', 'aluminium', '[]', 1, 1, 1, 'planned');"
          "INSERT INTO job_parameters VALUES (7, 2.5, 'gimp')");
  const auto db = open_for_writing(results);
  EXPECT_EQ(db->execAndGet("SELECT gone_since FROM jobs WHERE kernel = 'gimp'").getDouble(), 2.5);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM pragma_table_info('jobs') WHERE name = 'impact_speed_m_s'"),
            1);
  EXPECT_FALSE(db->tableExists("job_parameters"));
}

// Up to version 6 a bracket of any quantity was a speed; what it is of is told by the jobs that prove it.
TEST_F(Opening, brackets_of_an_older_layout_are_of_the_quantity_that_their_jobs_differ_in) {
  auto older = current_catalog_schema();
  older.migrations.resize(6);
  make_tables(results, older);
  {
    SQLite::Database db(path.string(), SQLite::OPEN_READWRITE);
    for (const char* column : {"impact_speed_m_s", "yield_stress_Pa"})
      db.exec("ALTER TABLE job ADD COLUMN " + std::string(column) +
              " REAL; INSERT INTO parameter_column (name) VALUES ('" + column + "')");
    db.exec(
        "INSERT INTO study (id, name, title, updated_at) VALUES (1, 'fast', '', ''), (2, 'firm', '', '')");
    const auto job = [&](const std::string& key, const std::string& speed, const std::string& yield) {
      db.exec(
          "INSERT INTO job (key, scene, material, snapshot_times, physics_version, predicted_particles, "
          "predicted_steps, status, impact_speed_m_s, yield_stress_Pa) VALUES ('" +
          key + "', 'cavity-impact', 'aluminium', '[]', 1, 1, 1, 'done', " + speed + ", " + yield + ")");
    };
    job("slow", "200", "3e8");
    job("fast", "210", "3e8");
    job("soft", "200", "1e8");
    job("firm", "200", "2e8");
    db.exec(
        "INSERT INTO critical_speed_bracket VALUES (1, 0, 1e-6, 200, 210, 'slow', 'fast', 1e-7, 190, 20, '', "
        "7),"
        "(2, 0, NULL, 1e8, 2e8, 'soft', 'firm', 1e-7, NULL, NULL, 'failed at 3e+08', 9),"
        "(2, 1, NULL, 300, 400, 'x', 'y', 1e-7, NULL, NULL, '', 5)");
  }
  const auto db = open_for_writing(results);
  const auto one = [&](const std::string& sql) { return db->execAndGet(sql).getString(); };
  EXPECT_EQ(
      one("SELECT quantity || ' ' || unit || ' ' || lower || ' ' || upper || ' ' || swept || ' ' || runs "
          "FROM brackets WHERE study = 'fast'"),
      "impact_speed m/s 200.0 210.0 {\"wall_thickness_m\":1.0e-06} 7");
  EXPECT_EQ(
      one("SELECT quantity || ' ' || unit || ' ' || lower || ' ' || upper || ' ' || swept || ' ' || flags "
          "FROM brackets WHERE study = 'firm' AND position = 0"),
      "yield_stress Pa 100000000.0 200000000.0 {} failed at 3e+08 Pa");
  EXPECT_EQ(one("SELECT quantity FROM brackets WHERE position = 1"), "impact_speed") << "as it was filed";
  EXPECT_EQ(one("SELECT group_concat(lower_m_s) FROM critical_speed"), "200.0,300.0");
  EXPECT_EQ(one("SELECT wall_thickness_m || ' ' || extrapolated_m_s || ' ' || interval_m_s FROM "
                "critical_speed WHERE study = 'fast'"),
            "1.0e-06 190.0 20.0");
}

// Up to version 6 a wall was stored as the difference of three lengths, with its rounding.
TEST_F(Opening, walls_of_an_older_layout_get_the_thickness_that_was_written) {
  auto older = current_catalog_schema();
  older.migrations.resize(6);
  make_tables(results, older);
  {
    SQLite::Database db(path.string(), SQLite::OPEN_READWRITE);
    for (const char* column :
         {"block_height_m", "cavity_center_height_m", "cavity_radius_m", "wall_thickness_m"})
      db.exec("ALTER TABLE job ADD COLUMN " + std::string(column) +
              " REAL; INSERT INTO parameter_column (name) VALUES ('" + column + "')");
    db.exec(
        "INSERT INTO job (key, scene, material, snapshot_times, physics_version, predicted_particles, "
        "predicted_steps, status, block_height_m, cavity_center_height_m, cavity_radius_m, wall_thickness_m) "
        "VALUES ('k', 'cavity-impact', 'aluminium', '[]', 1, 1, 1, 'done', 6e-6, 4e-6, 1e-6, 6e-6 - 4e-6 - "
        "1e-6)");
    db.exec("INSERT INTO study (id, name, title, updated_at) VALUES (1, 's', '', '')");
    db.exec(
        "INSERT INTO critical_speed_bracket VALUES (1, 0, 6e-6 - 4e-6 - 1e-6, 200, 210, 'k', 'k', 1e-7, "
        "NULL, "
        "NULL, '', 7)");
    ASSERT_EQ(integer(db, "SELECT count(*) FROM job WHERE wall_thickness_m = 1e-6"), 0);
  }
  const auto db = open_for_writing(results);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM jobs WHERE wall_thickness_m = 1e-6"), 1);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM critical_speed WHERE wall_thickness_m = 1e-6"), 1);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM brackets WHERE swept ->> 'wall_thickness_m' = 1e-6"), 1);
}

// Up to version 7 the views showed the last digits of what a number was computed from, flags of brackets had
// no unit, and a curve through as many points as coefficients had an r2.
TEST_F(Opening, numbers_of_an_older_layout_are_shown_as_they_were_written) {
  auto older = current_catalog_schema();
  older.migrations.resize(7);
  make_tables(results, older);
  {
    SQLite::Database db(path.string(), SQLite::OPEN_READWRITE);
    for (const char* column : {"cavity_center_height_m", "cavity_radius_m", "yield_stress_Pa"})
      db.exec("ALTER TABLE job ADD COLUMN " + std::string(column) +
              " REAL; INSERT INTO parameter_column (name) VALUES ('" + column + "')");
    db.exec(
        "INSERT INTO job (key, scene, material, snapshot_times, physics_version, predicted_particles, "
        "predicted_steps, status, cavity_center_height_m, cavity_radius_m, yield_stress_Pa) VALUES ('a', "
        "'cavity-impact', 'aluminium', '[]', 1, 1, 1, 'done', 4.000000000000001e-06, 1.2999999999999998e-06, "
        "9e999), ('b', 'cavity-impact', 'aluminium', '[]', 1, 1, 1, 'done', 1.23456789012345e-06, 0, NULL);"
        "INSERT INTO study (id, name, title, updated_at) VALUES (1, 's', '', '');"
        "INSERT INTO bracket (study_id, position, quantity, unit, lower, upper, lower_key, upper_key, "
        "cell_size_m, flags, swept) VALUES (1, 0, 'cavity_radius', 'm', 1.2999999999999998e-06, 1.4e-06, "
        "'k', "
        "'k', 7e-08, 'lower end undecided; failed at 1.5e-06; flips back at 1.6e-06', "
        "'{\"cavity_center_height_m\":4.000000000000001e-06,\"scheme\":\"gimp\"}');"
        "INSERT INTO fit (study_id, position, quantity, against, model, coefficient, value, r2, unit, "
        "points) "
        "VALUES (1, 0, 'a', 'x', 'linear', 'c0', 1, 1, '1', 2), (1, 1, 'a', 'x', 'linear', 'c1', 1, 1, '1', "
        "2),"
        "(1, 2, 'b', 'x', 'linear', 'c0', 1, 0.9, '1', 3), (1, 3, 'b', 'x', 'linear', 'c1', 1, 0.9, '1', 3)");
  }
  const auto db = open_for_writing(results);
  const auto one = [&](const std::string& sql) { return db->execAndGet(sql).getString(); };
  EXPECT_EQ(one("SELECT key FROM jobs WHERE cavity_center_height_m = 4e-6 AND cavity_radius_m = 1.3e-6"),
            "a");
  EXPECT_EQ(one("SELECT key FROM jobs WHERE cavity_radius_m = '1.3e-6'"), "a") << "a text is a number to it";
  EXPECT_EQ(one("SELECT key FROM jobs WHERE yield_stress_Pa = 9e999"), "a");
  EXPECT_EQ(one("SELECT key FROM jobs WHERE cavity_center_height_m = 1.23456789012345e-06"), "b");
  EXPECT_EQ(one("SELECT typeof(yield_stress_Pa) FROM jobs WHERE cavity_radius_m = 0"), "null");
  const auto stored = read_jobs(results, {"a", ""});
  ASSERT_EQ(stored.size(), 1u);
  EXPECT_EQ(stored[0].job.scene.cavity_radius, 1.2999999999999998e-06) << "keys are made of all digits";
  EXPECT_EQ(stored[0].job.scene.cavity_center_height, 4.000000000000001e-06);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM bracket WHERE exact_lower = 1.2999999999999998e-06"), 1);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM brackets WHERE lower = 1.3e-6 AND cell_size_m = 7e-8"), 1);
  EXPECT_EQ(one("SELECT flags FROM brackets"),
            "lower end undecided; failed at 1.5e-06 m; flips back at 1.6e-06 m");
  EXPECT_EQ(one("SELECT swept FROM brackets"), R"({"cavity_center_height_m":4e-06,"scheme":"gimp"})");
  EXPECT_EQ(one("SELECT group_concat(coalesce(r2, 'none')) FROM fits"), "none,none,0.9,0.9");
}

TEST_F(Opening, a_migration_that_fails_changes_nothing) {
  open_for_writing(results);
  auto next = current_catalog_schema();
  next.migrations.push_back({version + 1, "CREATE TABLE later (a INTEGER) STRICT; CREATE TABLE nonsense;"});
  EXPECT_THROW(open_for_writing(results, next), CatalogError);
  const auto db = open_for_writing(results);
  EXPECT_EQ(integer(*db, "PRAGMA user_version"), version);
  EXPECT_FALSE(db->tableExists("later"));
}

TEST_F(Opening, a_new_parameter_gains_a_column) {
  auto older = current_catalog_schema();
  older.parameters.erase(older.parameters.begin());  // impact_speed_m_s
  {
    const auto db = open_for_writing(results, older);
    EXPECT_EQ(integer(*db, "SELECT count(*) FROM pragma_table_info('jobs') WHERE name = 'impact_speed_m_s'"),
              0);
  }
  const auto db = open_for_writing(results);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM pragma_table_info('jobs') WHERE name = 'impact_speed_m_s'"),
            1);
  EXPECT_TRUE(fs::exists(backup));
  // The older program goes on with it, and takes nothing away.
  open_for_writing(results, older);
  EXPECT_EQ(integer(*db, "SELECT count(*) FROM pragma_table_info('jobs') WHERE name = 'impact_speed_m_s'"),
            1);
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
