// Catalogs of older programs become the current one; new parameters gain a column.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "tests/runner/catalog/opening.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

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

}  // namespace
}  // namespace mpmstudy
