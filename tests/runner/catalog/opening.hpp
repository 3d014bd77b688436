#pragma once
/// Catalogs of this and of older programs, for tests that open them.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/schema.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const CatalogError& error) {
    return error.what();
  }
  return "no CatalogError";
}

inline int integer(SQLite::Database& db, const std::string& sql) { return db.execAndGet(sql).getInt(); }

/// A catalog as an older program left it: its tables; the views follow when it is opened.
inline void make_tables(const std::filesystem::path& results, const CatalogSchema& schema) {
  std::filesystem::create_directories(results);
  SQLite::Database db(catalog_path(results).string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  for (const auto& migration : schema.migrations) db.exec(std::string(migration.sql));
  db.exec("PRAGMA application_id = " + std::to_string(catalog_application_id));
  db.exec("PRAGMA user_version = " + std::to_string(schema.version()));
}

class Opening : public testing::Test {
 protected:
  fakes::TemporaryFolder folder;
  std::filesystem::path results = folder.path() / "results";
  std::filesystem::path path = catalog_path(results);
  const int version = current_catalog_schema().version();
  const std::string backup = path.string() + ".v" + std::to_string(version) + ".backup";
};

}  // namespace mpmstudy
