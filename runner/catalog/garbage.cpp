#include "runner/catalog/garbage.hpp"

#include <fmt/format.h>

#include <set>
#include <unordered_set>

#include "runner/catalog/sql.hpp"
#include "runner/catalog/store_impl.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// Jobs that a study has, or that are being run: of them all stays.
constexpr const char* unwanted =
    "status <> 'running' AND NOT EXISTS (SELECT 1 FROM study_job WHERE job_id = job.id)";

/// Every table that hangs on a job.
constexpr const char* tables_of_a_job[] = {"metric",   "area_sample", "gauge",         "history_sample",
                                           "snapshot", "event",       "own_parameter", "interval"};

std::int64_t size_of(const fs::path& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

/// Folders of fields/ whose jobs are not wanted, or of which there is no job.
void find_folders(const fs::path& results, const std::unordered_set<std::string>& wanted, Garbage& garbage) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(results / "fields", error)) {
    if (!entry.is_directory(error) || wanted.contains(entry.path().filename().string())) continue;
    garbage.folders.push_back(entry.path());
    for (const auto& file : fs::recursive_directory_iterator(entry.path(), error)) {
      if (!file.is_regular_file(error)) continue;
      ++garbage.files;
      garbage.bytes += size_of(file.path());
    }
  }
}

/// Keys, former ones too, of jobs whose files stay.
std::unordered_set<std::string> wanted_keys(SQLite::Database& db) {
  std::unordered_set<std::string> keys;
  SQLite::Statement rows(db, std::string("SELECT key, former_key FROM job WHERE NOT (") + unwanted + ")");
  while (rows.executeStep()) {
    keys.insert(rows.getColumn(0).getString());
    if (!rows.isColumnNull(1)) keys.insert(rows.getColumn(1).getString());
  }
  return keys;
}

Garbage look(SQLite::Database& db, const fs::path& results) {
  Garbage garbage;
  garbage.jobs = db.execAndGet(std::string("SELECT count(*) FROM job WHERE ") + unwanted).getInt64();
  find_folders(results, wanted_keys(db), garbage);
  return garbage;
}

}  // namespace

Garbage find_garbage(const fs::path& results) {
  const auto db = open_for_reading(results);
  try {
    return look(*db, results);
  } catch (const SQLite::Exception& error) {
    throw CatalogError(catalog_path(results).string() + ": cannot be read (" + error.what() +
                       "); `mpmstudy run STUDY` brings a catalog of an older program up to date");
  }
}

DiskUse disk_use(const fs::path& results) {
  DiskUse use;
  const fs::path path = catalog_path(results);
  use.catalog = size_of(path) + size_of(path.string() + "-wal");
  for (const auto& row : ask(results, "SELECT coalesce(sum(bytes), 0) FROM snapshot").rows)
    use.fields = std::get<std::int64_t>(row[0]);
  for (const auto& row :
       ask(results,
           "SELECT coalesce(s.name, ''), sum(f.bytes) FROM snapshot f LEFT JOIN study_job m ON m.job_id = "
           "f.job_id LEFT JOIN study s ON s.id = m.study_id GROUP BY s.name ORDER BY s.name")
           .rows)
    use.studies.push_back({text_of(row[0]), std::get<std::int64_t>(row[1])});
  return use;
}

std::int64_t Store::forget(const std::string& name) {
  auto& db = *impl_->db;
  impl_->take_up();
  const auto study = impl_->study_id(name);
  SQLite::Statement running(db,
                            "SELECT r.host || ':' || r.pid FROM study_job m JOIN job j ON j.id = m.job_id "
                            "JOIN runner r ON r.id = j.runner_id WHERE m.study_id = ? AND j.status = "
                            "'running' LIMIT 1");
  running.bind(1, study);
  if (running.executeStep())
    throw CatalogError(
        fmt::format("{}: {} runs its jobs; stop that run first", name, running.getColumn(0).getString()));
  running.reset();
  SQLite::Statement count(
      db,
      "SELECT count(*) FROM study_job m WHERE study_id = ?1 AND NOT EXISTS (SELECT 1 FROM "
      "study_job o WHERE o.job_id = m.job_id AND o.study_id <> ?1)");
  count.bind(1, study);
  count.executeStep();
  const std::int64_t left_alone = count.getColumn(0).getInt64();
  count.reset();
  for (const char* table : {"study_job", "own_parameter", "fit", "interval", "bracket"}) {
    SQLite::Statement forget(db, std::string("DELETE FROM ") + table + " WHERE study_id = ?");
    execute(forget, study);
  }
  SQLite::Statement claims(db, "DELETE FROM claim WHERE study = ?");
  execute(claims, name);
  SQLite::Statement forget(db, "DELETE FROM study WHERE id = ?");
  execute(forget, study);
  impl_->cancel_unwanted();
  return left_alone;
}

std::int64_t Store::remove_unwanted_jobs() {
  auto& db = *impl_->db;
  impl_->take_up();
  db.exec(std::string("CREATE TEMP TABLE gone AS SELECT id FROM job WHERE ") + unwanted);
  for (const char* table : tables_of_a_job)
    db.exec(fmt::format("DELETE FROM {} WHERE job_id IN (SELECT id FROM temp.gone)", table));
  const std::int64_t jobs = db.exec("DELETE FROM job WHERE id IN (SELECT id FROM temp.gone)");
  db.exec("DROP TABLE temp.gone");
  return jobs;
}

std::vector<std::string> Store::remove_unwanted_files() {
  std::vector<std::string> left;
  for (const fs::path& folder : look(*impl_->db, impl_->results).folders) {
    std::error_code error;
    fs::remove_all(folder, error);
    if (error) left.push_back(folder.string() + ": " + error.message());
  }
  return left;
}

void Store::shrink() {
  if (impl_->db->tryExec("VACUUM") == SQLite::OK) impl_->db->tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
}

}  // namespace mpmstudy
