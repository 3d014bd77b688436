#include "runner/catalog/connection.hpp"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/catch_up.hpp"
#include "runner/catalog/file_system.hpp"
#include "runner/catalog/output_file.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// How long a statement waits for another process that writes [ms].
constexpr int busy_timeout_ms = 30'000;

/// ... where readers and the writer wait for each other [ms].
constexpr int busy_timeout_on_share_ms = 600'000;

struct Header {
  std::int32_t application_id = 0;
  std::int32_t version = 0;
  bool empty = true;  ///< no table at all
};

/// In one statement, so that it sees one state: between two of them another runner may make the catalog.
Header read_header(SQLite::Database& db) {
  SQLite::Statement row(
      db,
      "SELECT (SELECT application_id FROM pragma_application_id), (SELECT user_version FROM "
      "pragma_user_version), (SELECT count(*) FROM sqlite_schema)");
  row.executeStep();
  return {row.getColumn(0).getInt(), row.getColumn(1).getInt(), row.getColumn(2).getInt() == 0};
}

/// Throws unless the file is a catalog that this build can use, or is empty.
void check_header(const fs::path& path, const Header& header, std::int32_t newest) {
  if (header.application_id == 0 && header.version == 0 && header.empty) return;
  if (header.application_id != catalog_application_id)
    throw CatalogError(path.string() +
                       ": a database of another program; choose another folder with --results");
  if (header.version > newest)
    throw CatalogError(path.string() + ": written by a newer mpmstudy (catalog version " +
                       std::to_string(header.version) + ", this program knows up to " +
                       std::to_string(newest) +
                       "); nothing was changed; use the newer program or another folder (--results)");
}

/// Locks of the file system itself are refused, whoever asks.
bool is_without_locks(const SQLite::Exception& error) {
  const int code = error.getExtendedErrorCode();
  return code == SQLITE_IOERR_LOCK || code == SQLITE_IOERR_RDLOCK || code == SQLITE_IOERR_CHECKRESERVEDLOCK;
}

[[noreturn]] void rethrow(const fs::path& path, const SQLite::Exception& error) {
  if (is_without_locks(error))
    throw CatalogError(path.string() + ": its file system (" + file_system_of(path).name +
                       ") gives no file locks (" + refused_lock() +
                       "), without which no catalog can be written; choose a local folder with --results");
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      throw CatalogError(
          path.string() +
          ": is not a catalog (not a SQLite database); move it away or choose another folder with --results");
    case SQLITE_CORRUPT:
      throw CatalogError(path.string() + ": is damaged (" + error.what() +
                         "); restore it from a backup or choose another folder with --results");
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_IOERR:
    case SQLITE_PERM:
      throw CatalogError(
          path.string() + ": cannot be opened (" + error.what() + ")" + who_may(path) +
          "; check the permissions of file and folder, or choose another folder with --results");
    case SQLITE_BUSY:
      throw CatalogError(path.string() + ": another process has held it for too long; try again");
    default:
      throw CatalogError(path.string() + ": " + error.what());
  }
}

std::vector<std::string> parameters_of(SQLite::Database& db) {
  std::vector<std::string> names;
  SQLite::Statement rows(db, "SELECT name FROM parameter_column ORDER BY rowid");
  while (rows.executeStep()) names.push_back(rows.getColumn(0).getString());
  return names;
}

/// Parameters of the schema that the catalog has no column for yet.
std::vector<ParameterColumn> missing_columns(SQLite::Database& db, const CatalogSchema& schema) {
  const auto existing = parameters_of(db);
  std::vector<ParameterColumn> missing;
  for (const auto& column : schema.parameters)
    if (std::ranges::find(existing, column.name) == existing.end()) missing.push_back(column);
  return missing;
}

/// Copies the database as it is committed now; the name appears when the copy is whole.
void back_up(const fs::path& path, std::int32_t version) {
  const std::string stem = path.string() + ".v" + std::to_string(version) + ".backup";
  fs::path target = stem;
  for (int i = 2; fs::exists(target); ++i) target = stem + "-" + std::to_string(i);
  const fs::path partial = unique_name(target);
  {
    make_by_umask(partial);
    SQLite::Database from(path.string(), SQLite::OPEN_READONLY, busy_timeout_ms);
    SQLite::Database to(partial.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    SQLite::Backup(to, from).executeStep(-1);
  }
  fs::rename(partial, target);
}

void add_parameter(SQLite::Database& db, const ParameterColumn& column) {
  db.exec("ALTER TABLE job ADD COLUMN \"" + column.name + "\" " + column.type);
  SQLite::Statement name(db, "INSERT INTO parameter_column (name) VALUES (?)");
  name.bind(1, column.name);
  name.exec();
}

/// Up to version 5 parameters had a table of their own.
void move_parameters(SQLite::Database& db) {
  if (!db.tableExists("job_parameters")) return;
  std::string names;
  SQLite::Statement columns(
      db, "SELECT name, type FROM pragma_table_info('job_parameters') WHERE name <> 'job_id' ORDER BY cid");
  std::vector<ParameterColumn> moved;
  while (columns.executeStep())
    moved.push_back({columns.getColumn(0).getString(), columns.getColumn(1).getString()});
  columns.reset();
  for (const auto& column : moved) {
    add_parameter(db, column);
    names += (names.empty() ? "\"" : ", \"") + column.name + "\"";
  }
  if (!moved.empty())
    db.exec("UPDATE job SET (" + names + ") = (SELECT " + names +
            " FROM job_parameters WHERE job_id = job.id)");
  db.exec("DROP TABLE job_parameters");
}

bool is_current(SQLite::Database& db, const CatalogSchema& schema) {
  return read_header(db).version == schema.version() && missing_columns(db, schema).empty();
}

/// Under the write lock: another process may have done the same a moment before.
void bring_up_to_date(SQLite::Database& db, const fs::path& path, const CatalogSchema& schema) {
  if (is_current(db, schema)) return;
  SQLite::Transaction transaction(db, SQLite::TransactionBehavior::IMMEDIATE);
  if (is_current(db, schema)) return;
  const Header header = read_header(db);
  check_header(path, header, schema.version());
  if (header.version > 0) back_up(path, header.version);
  for (const auto& migration : schema.migrations)
    if (migration.version > header.version) db.exec(std::string(migration.sql));
  move_parameters(db);
  for (const auto& column : missing_columns(db, schema)) add_parameter(db, column);
  catch_up(db, header.version);
  db.exec(view_sql(parameters_of(db)));
  db.exec("PRAGMA application_id = " + std::to_string(catalog_application_id));
  db.exec("PRAGMA user_version = " + std::to_string(schema.version()));
  transaction.commit();
}

void check_is_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
    throw CatalogError(
        path.string() +
        ": cannot be opened (it is not a file); move it away or choose another folder with --results");
}

std::string uri_path(const fs::path& path) {
  std::string text;
  for (const char c : fs::absolute(path).string())
    if (c == '%')
      text += "%25";
    else if (c == '?')
      text += "%3f";
    else if (c == '#')
      text += "%23";
    else
      text += c;
  return text;
}

/// Refuses what is not ours before a connection that may write touches it. A process that was killed while
/// it made the catalog leaves a journal that only such a connection can play back: then that one looks.
void look_before_writing(const fs::path& path, const CatalogSchema& schema) {
  try {
    SQLite::Database db(path.string(), SQLite::OPEN_READONLY, busy_timeout_ms);
    check_header(path, read_header(db), schema.version());
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() != SQLITE_READONLY) throw;
  }
}

void make_folder(const fs::path& results) {
  std::error_code error;
  fs::create_directories(results, error);
  if (!error && !fs::is_directory(results)) error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw CatalogError(results.string() + ": cannot be used as the results folder (" + error.message() + ")" +
                       who_may_if_denied(results) + "; choose another with --results");
}

bool is_filled(const fs::path& path) {
  std::error_code none;
  const auto size = fs::file_size(path, none);
  return !none && size > 0;
}

}  // namespace

fs::path catalog_path(const fs::path& results) { return results / "catalog.db"; }

namespace {

std::unique_ptr<SQLite::Database> open_once(const fs::path& path, const CatalogSchema& schema) {
  if (fs::exists(path)) look_before_writing(path, schema);
  make_by_umask(path);
  const bool shared = file_system_of(path).shared;
  auto db = std::make_unique<SQLite::Database>(
      path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_NOMUTEX,
      shared ? busy_timeout_on_share_ms : busy_timeout_ms);
  check_header(path, read_header(*db), schema.version());
  // Takes effect in a new catalog only. A row of a job is long: answers over all of a large study go through
  // fewer pages.
  db->exec("PRAGMA page_size = 16384");
  // A log (WAL) has a part in memory that two machines do not share. A journal needs nothing but locks.
  db->exec(shared ? "PRAGMA journal_mode = DELETE" : "PRAGMA journal_mode = WAL");
  // NORMAL: a killed process loses nothing. A power cut may lose the last commits, never damage the file;
  // such jobs are planned again. With a journal only FULL keeps the file whole.
  db->exec(shared ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
  db->exec("PRAGMA foreign_keys = ON");
  bring_up_to_date(*db, path, schema);
  return db;
}

}  // namespace

std::unique_ptr<SQLite::Database> open_for_writing(const fs::path& results, const CatalogSchema& schema) {
  const fs::path path = catalog_path(results);
  watch_locks();
  make_folder(results);
  check_is_file(path);
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(busy_timeout_ms);
  while (true) try {
      return open_once(path, schema);
    } catch (const SQLite::Exception& error) {
      // Where two change the journal's mode, or play one back, at once, SQLite refuses instead of waiting.
      if (error.getErrorCode() != SQLITE_BUSY || std::chrono::steady_clock::now() > end) rethrow(path, error);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    } catch (const fs::filesystem_error& error) {
      throw CatalogError(path.string() + ": " + error.what());
    }
}

std::unique_ptr<SQLite::Database> open_for_reading(const fs::path& results) {
  const fs::path path = catalog_path(results);
  std::error_code error;
  if (!fs::exists(path, error)) {
    if (error) throw CatalogError(path.string() + ": cannot be read: " + error.message() + who_may(path));
    throw CatalogError(path.string() +
                       ": there is no catalog; `mpmstudy run STUDY` makes one, --results names its folder");
  }
  check_is_file(path);
  watch_locks();
  const int flags = SQLite::OPEN_READONLY | SQLite::OPEN_NOMUTEX;
  std::unique_ptr<SQLite::Database> db;
  try {
    Header header;
    try {
      db = std::make_unique<SQLite::Database>(path.string(), flags, busy_timeout_ms);
      header = read_header(*db);
    } catch (const SQLite::Exception& error) {
      // WAL needs a small file beside the catalog. Where none can be made nobody can write either.
      const bool unfinished = is_filled(path.string() + "-wal") || is_filled(path.string() + "-journal");
      const int code = error.getErrorCode();
      const bool without_locks = is_without_locks(error);
      if (without_locks && unfinished)
        throw CatalogError(path.string() + ": its file system gives no file locks (" + refused_lock() +
                           "), and the log beside it is not in it yet; copy the folder to a local disk and "
                           "read it there");
      if (code == SQLITE_READONLY && unfinished)
        throw UnfinishedCatalog(
            path.string() +
            ": a process was killed while it made the catalog; `mpmstudy run STUDY` finishes it");
      if (unfinished || (code != SQLITE_CANTOPEN && code != SQLITE_READONLY && !without_locks)) throw;
      db = std::make_unique<SQLite::Database>("file:" + uri_path(path) + "?immutable=1",
                                              flags | SQLite::OPEN_URI);
      header = read_header(*db);
    }
    db->exec("PRAGMA cache_size = -65536");  // [KiB]: questions over all jobs of a large study
    // Read in place they take a quarter to a third less time. A file that another machine cuts short while it
    // is read so ends the reader by a signal: not on a share.
    if (file_system_of(path).local) db->exec("PRAGMA mmap_size = 1073741824");  // [bytes]
    check_header(path, header, current_catalog_schema().version());
    if (header.version == 0)
      throw UnfinishedCatalog(path.string() + ": is empty; `mpmstudy run STUDY` fills it");
    return db;
  } catch (const SQLite::Exception& error) {
    rethrow(path, error);
  }
}

bool has_catalog(const fs::path& results) {
  std::error_code ignored;
  if (!fs::exists(catalog_path(results), ignored)) return false;
  try {
    open_for_reading(results);
    return true;
  } catch (const UnfinishedCatalog&) {
    return false;
  }
}

}  // namespace mpmstudy
