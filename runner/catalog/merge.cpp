// Taking over the jobs of another catalog, and their files.
#include <fmt/format.h>

#include "runner/catalog/field_files.hpp"
#include "runner/catalog/output_file.hpp"
#include "runner/catalog/results_of.hpp"
#include "runner/catalog/store_impl.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// Columns that both catalogs have, without those that mean something in one of them only.
std::string shared_columns(SQLite::Database& db, const std::string& table, const std::string& without) {
  SQLite::Statement rows(db,
                         "SELECT a.name FROM pragma_table_info(?1, 'main') a "
                         "JOIN pragma_table_info(?1, 'shard') b ON a.name = b.name "
                         "WHERE instr(?2, ' ' || a.name || ' ') = 0 ORDER BY a.cid");
  rows.bind(1, table);
  rows.bind(2, " " + without + " ");
  std::string names;
  while (rows.executeStep()) names += (names.empty() ? "\"" : ", \"") + rows.getColumn(0).getString() + "\"";
  return names;
}

/// Rows of one job from a table of the shard, instead of those it has here.
void copy_rows(SQLite::Database& db, const std::string& table, std::int64_t from, std::int64_t to) {
  SQLite::Statement clear(db, fmt::format("DELETE FROM main.{} WHERE job_id = ?", table));
  execute(clear, to);
  const auto columns = shared_columns(db, table, "job_id");
  SQLite::Statement copy(db, fmt::format("INSERT INTO main.{0} (job_id, {1}) SELECT ?, {1} FROM shard.{0} "
                                         "WHERE job_id = ?",
                                         table, columns));
  execute(copy, to, from);
}

/// What is wrong with the shard's files of a job, or "".
std::string damaged(SQLite::Database& db, const fs::path& folder, std::int64_t job) {
  SQLite::Statement files(db, "SELECT path, bytes, checksum FROM shard.snapshot WHERE job_id = ?");
  files.bind(1, job);
  std::string wrong;
  while (wrong.empty() && files.executeStep())
    wrong = what_is_wrong(folder / files.getColumn(0).getString(), files.getColumn(1).getInt64(),
                          files.getColumn(2).getString());
  return wrong;
}

/// The files get a second name here where that can be, else they are copied; the folder appears when whole.
void take_files(const fs::path& from, const fs::path& to) {
  fs::remove_all(to);
  if (!fs::exists(from)) return;
  const fs::path partial = to.string() + ".tmp";
  fs::remove_all(partial);
  fs::create_directories(partial);
  for (const auto& entry : fs::directory_iterator(from)) {
    std::error_code other_disk;
    const fs::path target = partial / entry.path().filename();
    fs::create_hard_link(entry.path(), target, other_disk);
    if (other_disk) fs::copy_file(entry.path(), target);
    sync_to_disk(target);
  }
  fs::rename(partial, to);
  sync_to_disk(to.parent_path());
}

/// A job whose key has changed keeps its files where they were.
std::string folder_of_files(SQLite::Database& db, const fs::path& folder, std::int64_t job,
                            const std::string& key) {
  if (fs::exists(folder / "fields" / key)) return key;
  SQLite::Statement former(db, "SELECT coalesce(former_key, key) FROM shard.job WHERE id = ?");
  former.bind(1, job);
  return former.executeStep() ? former.getColumn(0).getString() : key;
}

struct ShardJob {
  std::int64_t id;
  std::string key;
  JobStatus status;
};

std::vector<ShardJob> decided_jobs(SQLite::Database& db) {
  std::vector<ShardJob> jobs;
  SQLite::Statement rows(
      db, "SELECT id, key, status FROM shard.job WHERE status IN ('done', 'failed') ORDER BY id");
  while (rows.executeStep())
    jobs.push_back({rows.getColumn(0).getInt64(), rows.getColumn(1).getString(),
                    job_status_from(rows.getColumn(2).getString())});
  return jobs;
}

/// Studies that this catalog did not have before come with their jobs.
void take_studies(SQLite::Database& db, std::set<std::string>& taken) {
  SQLite::Statement unknown(db,
                            "SELECT name FROM shard.study WHERE name NOT IN (SELECT name FROM main.study)");
  while (unknown.executeStep()) taken.insert(unknown.getColumn(0).getString());
  for (const auto& name : taken) {
    SQLite::Statement study(
        db,
        "INSERT OR IGNORE INTO main.study (name, title, updated_at, path, overrides, cells) "
        "SELECT name, title, updated_at, path, overrides, cells FROM shard.study WHERE name = ?");
    execute(study, name);
    SQLite::Statement members(
        db,
        "INSERT OR IGNORE INTO main.study_job (study_id, job_id, position, coarse, reason) "
        "SELECT s.id, j.id, m.position, m.coarse, m.reason "
        "FROM shard.study_job m JOIN shard.study t ON t.id = m.study_id JOIN main.study s ON s.name = t.name "
        "JOIN shard.job k ON k.id = m.job_id JOIN main.job j ON j.key = k.key WHERE t.name = ?");
    execute(members, name);
  }
}

}  // namespace

MergeReport Store::merge(const fs::path& folder) {
  const auto shard = open_for_reading(folder);  // throws what is wrong with it
  if (shard->execAndGet("PRAGMA user_version").getInt() != current_catalog_schema().version())
    throw CatalogError(catalog_path(folder).string() +
                       ": written by an older mpmstudy; `mpmstudy retry --results " + folder.string() +
                       "` brings it up to date");
  auto& db = *impl_->db;
  SQLite::Statement attach(db, "ATTACH ? AS shard");
  attach.bind(1, fs::absolute(catalog_path(folder)).string());
  attach.exec();
  MergeReport report;
  begin();
  try {
    for (const auto& theirs : decided_jobs(db))
      impl_->merge_job(theirs.id, theirs.key, theirs.status, folder, *shard, report);
    take_studies(db, impl_->merged_studies);
    commit();
  } catch (...) {
    rollback();
    db.tryExec("DETACH shard");
    throw;
  }
  db.exec("DETACH shard");
  return report;
}

void Store::Impl::merge_job(std::int64_t theirs, const std::string& key, JobStatus status,
                            const fs::path& folder, SQLite::Database& shard, MergeReport& report) {
  const auto ours = find(key);
  if (ours && ours->status == JobStatus::done && status == JobStatus::done) {
    const auto wrong = difference(results_of(*db, key), results_of(shard, key));
    if (wrong.empty()) return void(++report.same);
    report.conflicts.push_back(key + ": two results under one key: " + wrong);
    return;
  }
  if (ours && (ours->status == JobStatus::done || ours->status == JobStatus::failed) &&
      status == JobStatus::failed)
    return void(++report.same);
  if (const auto wrong = damaged(*db, folder, theirs); !wrong.empty()) {
    report.damaged.push_back(wrong);
    return;
  }
  const auto columns = shared_columns(*db, "job", "id runner_id attempt");
  if (!ours) {
    SQLite::Statement insert(
        *db, fmt::format("INSERT INTO main.job ({0}) SELECT {0} FROM shard.job WHERE id = ?", columns));
    execute(insert, theirs);
  }
  const std::int64_t id = ours ? ours->id : db->getLastInsertRowid();
  SQLite::Statement update(
      *db, fmt::format("UPDATE main.job SET ({0}, runner_id, attempt) = (SELECT {0}, ?, ? FROM shard.job "
                       "WHERE id = ?) WHERE id = ?",
                       columns));
  const std::int64_t attempt = (ours ? ours->attempt : 0) + 1;
  execute(update, runner, attempt, theirs, id);
  for (const char* table : {"metric", "area_sample", "gauge", "history_sample", "snapshot"})
    copy_rows(*db, table, theirs, id);
  const std::string files = folder_of_files(*db, folder, theirs, key);
  take_files(folder / "fields" / files, results / "fields" / files);
  record(id, ours ? std::optional(ours->status) : std::nullopt, status, attempt,
         "merged from " + folder.string());
  ++report.merged;
}

}  // namespace mpmstudy
