#pragma once
/// The inside of Store: its statements, and what its parts share. One thread.
#include <SQLiteCpp/SQLiteCpp.h>

#include <map>
#include <set>
#include <unordered_set>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/bind.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/heartbeats.hpp"
#include "runner/catalog/store.hpp"
#include "runner/catalog/timestamp.hpp"

namespace mpmstudy {

/// INSERT INTO job: what is planned, and every parameter that a scene can have.
inline std::string insert_job_sql() {
  std::string names =
      "key, scene, material, snapshot_times, physics_version, predicted_particles, predicted_steps, "
      "predicted_s, gauges, status";
  std::string marks = "?, ?, ?, ?, ?, ?, ?, ?, ?, 'planned'";
  for (const auto& q : mpm::quantities()) names += ", \"" + std::string(q.column) + "\"", marks += ", ?";
  for (const auto& c : mpm::choices()) names += ", \"" + std::string(c.column) + "\"", marks += ", ?";
  return "INSERT INTO job (" + names + ", exact, composition) VALUES (" + marks + ", ?, ?)";
}

struct Store::Impl {
  std::filesystem::path results;
  StoreOptions options;
  std::unique_ptr<SQLite::Database> db;
  std::int64_t runner = 0;
  std::unordered_set<std::string> reserved;  ///< keys of jobs that this process runs, or did
  std::unordered_set<std::string> held;      ///< ... that it has neither decided nor released
  Heartbeats heartbeats;                     ///< of other runners

  SQLite::Statement select_job{*db, "SELECT id, status, attempt, runner_id, crashes FROM job WHERE key = ?"};
  SQLite::Statement insert_job{*db, insert_job_sql()};
  SQLite::Statement insert_label{*db, "INSERT OR REPLACE INTO own_parameter VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement insert_member{
      *db,
      "INSERT OR IGNORE INTO study_job (study_id, job_id, position, coarse, reason) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement plan_again{
      *db,
      "UPDATE job SET status = 'planned', reason = NULL, failure_kind = NULL, runner_id = NULL, "
      "started_at = NULL WHERE id = ?"};
  SQLite::Statement add_crash{*db, "UPDATE job SET crashes = crashes + 1 WHERE id = ?"};
  SQLite::Statement start{
      *db,
      "UPDATE job SET status = 'running', reason = NULL, attempt = attempt + 1, runner_id = ?, "
      "started_at = ?, finished_at = NULL WHERE id = ?"};
  SQLite::Statement end{
      *db,
      "UPDATE job SET status = ?, reason = ?, failure_kind = ?, finished_at = ?, particles = ?, steps = ?, "
      "wall_s = ?, cpu_s = "
      "?, "
      "energy_error = ?, outcome = ?, initial_area_m2 = ?, final_area_m2 = ?, final_area_error_m2 = ?, "
      "collapsibility = ?, collapsibility_error = ?, git_revision = ?, host = ? WHERE id = ?"};
  SQLite::Statement insert_metric{
      *db, "INSERT OR REPLACE INTO metric (job_id, name, value, unit, error) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement insert_area{
      *db, "INSERT INTO area_sample (job_id, sample, time_s, area_m2, void_area_m2) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement insert_gauge{*db, "INSERT INTO gauge (job_id, gauge, name, unit) VALUES (?, ?, ?, ?)"};
  SQLite::Statement insert_history_sample{
      *db, "INSERT INTO history_sample (job_id, gauge, sample, time_s, value) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement insert_snapshot{*db,
                                    "INSERT OR REPLACE INTO snapshot (job_id, time_s, step, path, bytes, "
                                    "checksum, modified_ns) VALUES (?, ?, ?, ?, ?, ?, ?)"};
  SQLite::Statement insert_event{
      *db,
      "INSERT INTO event (job_id, from_status, to_status, at, runner_id, attempt, reason) "
      "VALUES (?, ?, ?, ?, ?, ?, ?)"};
  SQLite::Statement delete_metrics{*db, "DELETE FROM metric WHERE job_id = ?"};
  SQLite::Statement delete_area{*db, "DELETE FROM area_sample WHERE job_id = ?"};
  SQLite::Statement delete_gauges{*db, "DELETE FROM gauge WHERE job_id = ?"};
  SQLite::Statement delete_history_samples{*db, "DELETE FROM history_sample WHERE job_id = ?"};
  SQLite::Statement delete_snapshots{*db, "DELETE FROM snapshot WHERE job_id = ?"};

  struct Row {
    std::int64_t id = 0;
    JobStatus status = JobStatus::planned;
    std::int64_t attempt = 0;
    std::int64_t runner = 0;  ///< 0: none
    std::int64_t crashes = 0;
  };

  Impl(const std::filesystem::path& folder, StoreOptions given)
      : results(folder), options(std::move(given)), db(open_for_writing(folder)) {}

  std::optional<Row> find(const std::string& key) {
    select_job.tryReset();
    select_job.bind(1, key);
    if (!select_job.executeStep()) return std::nullopt;
    Row row{select_job.getColumn(0).getInt64(), job_status_from(select_job.getColumn(1).getString()),
            select_job.getColumn(2).getInt64(), select_job.getColumn(3).getInt64(),
            select_job.getColumn(4).getInt64()};
    select_job.reset();  // else the read transaction would stay open
    return row;
  }

  /// The job, if this process runs it. Empty if it did until another process took it up.
  std::optional<Row> find_mine(const std::string& key) {
    const auto row = find(key);
    if (row && row->status == JobStatus::running && row->runner == runner) return row;
    if (!row || !reserved.contains(key)) throw CatalogError("job " + key + " is not run by this process");
    return std::nullopt;
  }

  void record(std::int64_t job, std::optional<JobStatus> from, JobStatus to, std::int64_t attempt,
              const std::string& reason = {}) {
    const auto from_text = from ? std::optional(std::string(to_string(*from))) : std::nullopt;
    execute(insert_event, job, from_text, std::string(to_string(to)), utc_now(), runner, attempt,
            or_null(reason));
  }

  void enter() {
    SQLite::Statement insert(
        *db,
        "INSERT INTO runner (host, boot_id, name_space, pid, process_start, git_revision, started_at, "
        "heartbeat_at, expires_s) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
    const auto now = utc_now();
    const auto& p = options.process;
    execute(insert, p.host, p.boot_id, p.name_space, p.pid, p.process_start, options.git_revision, now, now,
            options.heartbeat_expires_s);
    runner = db->getLastInsertRowid();
  }

  std::int64_t study_id(const std::string& name) {
    SQLite::Statement select(*db, "SELECT id FROM study WHERE name = ?");
    select.bind(1, name);
    if (!select.executeStep()) throw CatalogError("catalog: there is no study '" + name + "'");
    return select.getColumn(0).getInt64();
  }

  // registration.cpp
  /// The row of a job. One that was filed under the job's former key gets the new one.
  std::optional<Row> find(const Job&);
  std::int64_t add_job(const Job&);
  void enter_labels(std::int64_t study, std::int64_t job, const mpm::Scene&);
  /// Runners with running jobs that are gone: id -> who.
  std::map<std::int64_t, std::string> gone_runners();
  /// Plans again what processes that are gone have left running. Gives back the ids of these jobs.
  std::set<std::int64_t> take_up();
  /// Plans one running job again if its process is gone.
  bool take_up(const Row&);
  /// Cancels planned jobs that no study has.
  void cancel_unwanted();

  // merge.cpp
  void merge_job(std::int64_t theirs, const std::string& key, JobStatus, const std::filesystem::path& folder,
                 SQLite::Database& shard, MergeReport&);
  std::set<std::string> merged_studies;  ///< that came by merging

  // field_files.cpp
  /// Done jobs of a study whose files are not as they were written: id -> what is wrong.
  std::map<std::int64_t, std::string> damaged_jobs(std::int64_t study);

  /// Everything that a decided job leaves, instead of what an earlier attempt left. `host`, `git_revision`:
  /// of the program that ran it.
  void write_result(std::int64_t id, const FinishedJob&, const std::string& finished_at,
                    const std::string& host, const std::string& git_revision);

 private:
  void take_from(std::int64_t job, std::int64_t attempt, const std::string& who);
};

}  // namespace mpmstudy
