// `query` reads; it cannot write, attach or load, whatever it is told.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

class Query : public testing::Test {
 protected:
  Query() {
    CatalogWriter writer(folder.path());
    writer.register_study("s", "S", fakes::plan(3).jobs, false);
  }
  std::string bytes() {
    std::ifstream file(catalog_path(folder.path()), std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }
  fakes::TemporaryFolder folder;
};

TEST_F(Query, reads_views_with_functions_and_recursion) {
  EXPECT_EQ(query(folder.path(), "SELECT count(*), max(cavity_radius_m) FROM jobs").rows.size(), 1u);
  EXPECT_EQ(query(folder.path(),
                  "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 5) "
                  "SELECT i FROM n;  -- and a comment")
                .rows.size(),
            5u);
  EXPECT_EQ(
      query(folder.path(), "SELECT group_concat(upper(status)) OVER (ORDER BY key) FROM jobs").rows.size(),
      3u);
  EXPECT_GT(query(folder.path(), "PRAGMA table_info(jobs)").rows.size(), 20u);
  EXPECT_GT(query(folder.path(), "EXPLAIN QUERY PLAN SELECT * FROM jobs").rows.size(), 0u);
  const SqlValue parameters[] = {std::string("s"), std::int64_t{2}};
  EXPECT_EQ(query(folder.path(), "SELECT key FROM jobs WHERE study = ?1 LIMIT ?2", parameters).rows.size(),
            2u);
}

TEST_F(Query, refuses_everything_else) {
  const auto before = bytes();
  const std::string other = (folder.path() / "other.db").string();
  for (const std::string& sql : {
           std::string("DELETE FROM job"),
           std::string("UPDATE job SET status = 'done'"),
           std::string("INSERT INTO study (name, title, updated_at) VALUES ('x', 'x', 'x')"),
           std::string("WITH d AS (SELECT 1) DELETE FROM job"),
           std::string("DROP VIEW jobs"),
           std::string("CREATE TABLE t (a)"),
           std::string("CREATE TEMP TABLE t (a)"),
           std::string("CREATE TEMP VIEW v AS SELECT 1"),
           std::string("ALTER TABLE job RENAME TO j"),
           "ATTACH '" + other + "' AS o",
           "VACUUM INTO '" + other + "'",
           std::string("VACUUM"),
           std::string("REINDEX"),
           std::string("ANALYZE"),
           std::string("DETACH main"),
           std::string("BEGIN IMMEDIATE"),
           std::string("SAVEPOINT s"),
           std::string("PRAGMA user_version = 99"),
           std::string("PRAGMA journal_mode = DELETE"),
           std::string("PRAGMA writable_schema = ON"),
           std::string("PRAGMA query_only = OFF"),
           std::string("PRAGMA wal_checkpoint(TRUNCATE)"),
           std::string("PRAGMA temp_store_directory = '/tmp'"),
           std::string("SELECT * FROM pragma_wal_checkpoint"),
           std::string("SELECT load_extension('libm.so.6')"),
           std::string("SELECT LOAD_EXTENSION('libm.so.6', 'x')"),
           std::string("SELECT fts3_tokenizer('simple', x'00')"),
           std::string("SELECT writefile('" + other + "', 'x')"),
           std::string("SELECT readfile('/etc/passwd')"),
           std::string("SELECT edit('x')"),
           std::string("CREATE VIRTUAL TABLE v USING fts5(a)"),
           std::string("SELECT 1; DELETE FROM job"),
           std::string("SELECT 1; SELECT 2"),
           std::string("SELECT 1; nonsense"),
           std::string(""),
           std::string(" -- nothing"),
           std::string("SELEC 1"),
           std::string("SELECT * FROM nowhere"),
           std::string("SELECT 1\0; DELETE FROM job", 26),
       }) {
    EXPECT_THROW(query(folder.path(), sql), CatalogError) << sql;
  }
  EXPECT_EQ(bytes(), before);
  EXPECT_FALSE(std::filesystem::exists(other));
}

TEST_F(Query, ends_what_takes_too_long_or_too_much) {
  const auto message_of = [&](const std::string& sql) -> std::string {
    try {
      Rows rows;
      query(folder.path(), sql, rows, {}, 0.1);
    } catch (const CatalogError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(
      message_of("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n"),
      testing::HasSubstr("too long"));
  EXPECT_THAT(message_of("SELECT hex(zeroblob(900000000))"), testing::HasSubstr("too big"));
  EXPECT_EQ(message_of("SELECT 1"), "");
}

TEST_F(Query, says_what_is_allowed) {
  try {
    query(folder.path(), "DELETE FROM job");
    FAIL();
  } catch (const CatalogError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("only reading is allowed"));
  }
}

TEST_F(Query, needs_a_catalog) { EXPECT_THROW(query(folder.path() / "none", "SELECT 1"), CatalogError); }

}  // namespace
}  // namespace mpmstudy
