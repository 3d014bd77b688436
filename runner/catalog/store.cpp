#include "runner/catalog/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/timestamp.hpp"

namespace mpmstudy {
namespace {

// bind(statement, 1, a, b, ...): optionals and numbers that are none become null.
void bind_one(SQLite::Statement& s, int i, double v) { std::isnan(v) ? s.bind(i) : s.bind(i, v); }
void bind_one(SQLite::Statement& s, int i, std::int64_t v) { s.bind(i, v); }
void bind_one(SQLite::Statement& s, int i, int v) { s.bind(i, v); }
void bind_one(SQLite::Statement& s, int i, const std::string& v) { s.bind(i, v); }
template <class T>
void bind_one(SQLite::Statement& s, int i, const std::optional<T>& v) {
  v ? bind_one(s, i, *v) : s.bind(i);
}

template <class... Values>
void execute(SQLite::Statement& statement, const Values&... values) {
  statement.tryReset();  // an earlier failure was thrown when it happened
  int i = 0;
  (bind_one(statement, ++i, values), ...);
  statement.exec();
}

std::optional<std::string> or_null(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// INSERT INTO job_parameters over every column that a scene fills.
std::string insert_parameters_sql() {
  std::string names = "job_id", marks = "?";
  for (const auto& q : mpm::quantities()) names += ", \"" + std::string(q.column) + "\"", marks += ", ?";
  for (const auto& c : mpm::choices()) names += ", \"" + std::string(c.column) + "\"", marks += ", ?";
  return "INSERT INTO job_parameters (" + names + ") VALUES (" + marks + ")";
}

}  // namespace

struct Store::Impl {
  StoreOptions options;
  std::unique_ptr<SQLite::Database> db;
  std::int64_t runner = 0;

  SQLite::Statement select_job{*db, "SELECT id, status, attempt, runner_id FROM job WHERE key = ?"};
  SQLite::Statement insert_job{*db,
                               "INSERT INTO job (key, scene, material, snapshot_times, physics_version, "
                               "predicted_particles, predicted_steps, predicted_s, status) "
                               "VALUES (?, ?, ?, ?, ?, ?, ?, ?, 'planned')"};
  SQLite::Statement insert_parameters{*db, insert_parameters_sql()};
  SQLite::Statement insert_member{
      *db, "INSERT OR IGNORE INTO study_job (study_id, job_id, position, coarse) VALUES (?, ?, ?, ?)"};
  SQLite::Statement plan_again{
      *db,
      "UPDATE job SET status = 'planned', reason = NULL, runner_id = NULL, started_at = NULL WHERE id = ?"};
  SQLite::Statement start{
      *db,
      "UPDATE job SET status = 'running', reason = NULL, attempt = attempt + 1, runner_id = ?, "
      "started_at = ?, finished_at = NULL WHERE id = ?"};
  SQLite::Statement end{
      *db,
      "UPDATE job SET status = ?, reason = ?, finished_at = ?, particles = ?, steps = ?, wall_s = ?, cpu_s = "
      "?, "
      "energy_error = ?, outcome = ?, initial_area_m2 = ?, final_area_m2 = ?, final_area_error_m2 = ?, "
      "collapsibility = ?, collapsibility_error = ?, git_revision = ?, host = ? WHERE id = ?"};
  SQLite::Statement insert_metric{
      *db, "INSERT OR REPLACE INTO metric (job_id, name, value, unit, error) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement insert_area{
      *db, "INSERT INTO area_sample (job_id, sample, time_s, area_m2, void_area_m2) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement insert_snapshot{*db,
                                    "INSERT OR REPLACE INTO snapshot (job_id, time_s, step, path, bytes, "
                                    "checksum) VALUES (?, ?, ?, ?, ?, ?)"};
  SQLite::Statement insert_event{
      *db,
      "INSERT INTO event (job_id, from_status, to_status, at, runner_id, attempt, reason) "
      "VALUES (?, ?, ?, ?, ?, ?, ?)"};
  SQLite::Statement delete_metrics{*db, "DELETE FROM metric WHERE job_id = ?"};
  SQLite::Statement delete_area{*db, "DELETE FROM area_sample WHERE job_id = ?"};
  SQLite::Statement delete_snapshots{*db, "DELETE FROM snapshot WHERE job_id = ?"};

  struct Row {
    std::int64_t id = 0;
    JobStatus status = JobStatus::planned;
    std::int64_t attempt = 0;
    std::int64_t runner = 0;  ///< 0: none
  };

  Impl(const std::filesystem::path& results, StoreOptions given)
      : options(std::move(given)), db(open_for_writing(results)) {}

  std::optional<Row> find(const std::string& key) {
    select_job.tryReset();
    select_job.bind(1, key);
    if (!select_job.executeStep()) return std::nullopt;
    Row row{select_job.getColumn(0).getInt64(), job_status_from(select_job.getColumn(1).getString()),
            select_job.getColumn(2).getInt64(), select_job.getColumn(3).getInt64()};
    select_job.reset();  // or the statement would hold the read open
    return row;
  }

  Row find_mine(const std::string& key) {
    const auto row = find(key);
    if (!row || row->status != JobStatus::running || row->runner != runner)
      throw CatalogError("job " + key + " is not run by this process (any longer); its result is dropped");
    return *row;
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
        "INSERT INTO runner (host, boot_id, pid, process_start, git_revision, started_at, "
        "heartbeat_at) VALUES (?, ?, ?, ?, ?, ?, ?)");
    const auto now = utc_now();
    const auto& p = options.process;
    execute(insert, p.host, p.boot_id, p.pid, p.process_start, options.git_revision, now, now);
    runner = db->getLastInsertRowid();
  }

  std::int64_t add_job(const Job& job) {
    const auto& scene = job.scene;
    execute(insert_job, job.key, std::string(mpm::to_string(scene.kind)), scene.material.name,
            nlohmann::json(scene.measures.snapshots).dump(), mpm::physics_version, job.estimate.particles,
            job.estimate.steps, job.predicted_seconds);
    const std::int64_t id = db->getLastInsertRowid();
    insert_parameters.tryReset();
    int i = 0;
    bind_one(insert_parameters, ++i, id);
    for (const auto& q : mpm::quantities())
      bind_one(insert_parameters, ++i,
               q.belongs_to(scene.kind) ? std::optional(q.get(scene)) : std::optional<double>());
    for (const auto& c : mpm::choices())
      bind_one(insert_parameters, ++i,
               c.belongs_to(scene.kind) ? std::optional(std::string(c.allowed[c.get(scene)]))
                                        : std::optional<std::string>());
    insert_parameters.exec();
    record(id, std::nullopt, JobStatus::planned, 0);
    return id;
  }

  struct Entered {
    std::int64_t id = 0;
    JobStatus status = JobStatus::planned;
  };
  /// The job of this key, made if there is none, planned again if it was cancelled or is to be retried.
  Entered enter_job(const Job& job, bool retry_failed) {
    const auto row = find(job.key);
    if (!row) return {add_job(job)};
    const bool again =
        row->status == JobStatus::cancelled || (row->status == JobStatus::failed && retry_failed);
    if (!again) return {row->id, row->status};
    execute(plan_again, row->id);
    record(row->id, row->status, JobStatus::planned, row->attempt,
           row->status == JobStatus::failed ? "retry of a failed job" : "wanted again");
    return {row->id};
  }

  std::int64_t study_id(const std::string& name) {
    SQLite::Statement select(*db, "SELECT id FROM study WHERE name = ?");
    select.bind(1, name);
    if (!select.executeStep()) throw CatalogError("catalog: there is no study '" + name + "'");
    return select.getColumn(0).getInt64();
  }

  bool is_gone(SQLite::Statement& r, const std::string& now) {
    const ProcessId process{r.getColumn(1).getString(), r.getColumn(2).getString(), r.getColumn(3).getInt64(),
                            r.getColumn(4).getInt64()};
    if (!r.isColumnNull(6)) return true;
    if (r.getColumn(0).getInt64() == runner) return false;
    const auto state = liveness(process);
    if (state != Liveness::unknown) return state == Liveness::gone;
    return seconds_between(r.getColumn(5).getString(), now) > options.heartbeat_expires_s;
  }

  /// Plans again what processes that are gone have left running. Gives back the ids of these jobs.
  std::set<std::int64_t> take_up() {
    std::map<std::int64_t, std::string> gone;  // runner -> who
    const auto now = utc_now();
    SQLite::Statement runners(
        *db,
        "SELECT id, host, boot_id, pid, process_start, heartbeat_at, ended_at FROM runner "
        "WHERE id IN (SELECT runner_id FROM job WHERE status = 'running')");
    while (runners.executeStep())
      if (is_gone(runners, now))
        gone[runners.getColumn(0).getInt64()] =
            runners.getColumn(1).getString() + ":" + runners.getColumn(3).getString();
    std::set<std::int64_t> taken;
    for (const auto& [id, who] : gone) {
      std::vector<std::pair<std::int64_t, std::int64_t>> jobs;  // id, attempt
      SQLite::Statement left(*db, "SELECT id, attempt FROM job WHERE status = 'running' AND runner_id = ?");
      left.bind(1, id);
      while (left.executeStep())
        jobs.emplace_back(left.getColumn(0).getInt64(), left.getColumn(1).getInt64());
      for (const auto& [job, attempt] : jobs) {
        execute(plan_again, job);
        record(job, JobStatus::running, JobStatus::planned, attempt, "process " + who + " is gone");
        taken.insert(job);
      }
    }
    return taken;
  }

  void cancel_unwanted() {
    std::vector<std::pair<std::int64_t, std::int64_t>> jobs;
    SQLite::Statement unwanted(*db,
                               "SELECT id, attempt FROM job WHERE status = 'planned' AND NOT EXISTS "
                               "(SELECT 1 FROM study_job WHERE job_id = job.id)");
    while (unwanted.executeStep())
      jobs.emplace_back(unwanted.getColumn(0).getInt64(), unwanted.getColumn(1).getInt64());
    SQLite::Statement cancel(*db, "UPDATE job SET status = 'cancelled' WHERE id = ?");
    for (const auto& [job, attempt] : jobs) {
      execute(cancel, job);
      record(job, JobStatus::planned, JobStatus::cancelled, attempt, "no study has it any longer");
    }
  }
};

Store::Store(const std::filesystem::path& results, StoreOptions options)
    : impl_(std::make_unique<Impl>(results, std::move(options))) {
  begin();
  impl_->enter();
  commit();
}

Store::~Store() = default;

void Store::begin() { impl_->db->exec("BEGIN IMMEDIATE"); }
void Store::commit() { impl_->db->exec("COMMIT"); }
void Store::rollback() { impl_->db->tryExec("ROLLBACK"); }
void Store::begin_part() { impl_->db->exec("SAVEPOINT part"); }
void Store::commit_part() { impl_->db->exec("RELEASE part"); }
void Store::rollback_part() { impl_->db->exec("ROLLBACK TO part; RELEASE part"); }

Registration Store::register_study(const std::string& name, const std::string& title,
                                   const std::vector<Job>& jobs, bool retry_failed) {
  auto& db = *impl_->db;
  SQLite::Statement upsert(db,
                           "INSERT INTO study (name, title, updated_at) VALUES (?, ?, ?) ON CONFLICT (name) "
                           "DO UPDATE SET title = excluded.title, updated_at = excluded.updated_at");
  execute(upsert, name, title, utc_now());
  const std::int64_t study = impl_->study_id(name);
  SQLite::Statement forget(db, "DELETE FROM study_job WHERE study_id = ?");
  execute(forget, study);

  const auto taken_up = impl_->take_up();
  Registration registration;
  std::int64_t position = 0;
  for (const auto& job : jobs) {
    const auto [id, status] = impl_->enter_job(job, retry_failed);
    execute(impl_->insert_member, study, id, job.rung_of ? *job.rung_of : position++, job.rung_of ? 1 : 0);
    registration.states.push_back(status);
    if (status == JobStatus::planned) {
      registration.to_run.push_back(job.key);
      registration.taken_up += taken_up.contains(id);
    } else if (status == JobStatus::done) {
      ++registration.done;
    } else if (status == JobStatus::failed) {
      ++registration.failed;
    } else {
      ++registration.running_elsewhere;
    }
  }
  impl_->cancel_unwanted();
  return registration;
}

JobStatus Store::add_finer(const std::string& study, const Job& rung, bool retry_failed) {
  const auto id = impl_->study_id(study);
  const auto [job, status] = impl_->enter_job(rung, retry_failed);
  SQLite::Statement coarser(*impl_->db,
                            "UPDATE study_job SET coarse = 1 WHERE study_id = ? AND position = ?");
  execute(coarser, id, rung.rung_of);
  execute(impl_->insert_member, id, job, rung.rung_of, 0);
  return status;
}

bool Store::claim(const std::string& key) {
  const auto row = impl_->find(key);
  if (!row || row->status != JobStatus::planned) return false;
  execute(impl_->start, impl_->runner, utc_now(), row->id);
  impl_->record(row->id, JobStatus::planned, JobStatus::running, row->attempt + 1);
  return true;
}

void Store::release(const std::string& key, const std::string& reason) {
  const auto row = impl_->find_mine(key);
  execute(impl_->plan_again, row.id);
  impl_->record(row.id, JobStatus::running, JobStatus::planned, row.attempt, reason);
}

void Store::finish(const FinishedJob& job) {
  const auto row = impl_->find_mine(job.key);
  const auto& r = job.result;
  execute(impl_->delete_metrics, row.id);
  execute(impl_->delete_area, row.id);
  execute(impl_->delete_snapshots, row.id);
  for (const auto& m : r.metrics) execute(impl_->insert_metric, row.id, m.name, m.value, m.unit, m.error);
  std::int64_t sample = 0;
  for (const auto& a : r.area_history)
    execute(impl_->insert_area, row.id, sample++, a.time, a.area, a.void_area);
  for (const auto& s : job.snapshots)
    execute(impl_->insert_snapshot, row.id, s.time, s.step, s.path, s.bytes, s.checksum);
  execute(impl_->end, std::string(to_string(job.status)), or_null(job.reason), utc_now(), r.particles,
          r.steps, job.wall_s, job.cpu_s, r.energy_error, or_null(r.outcome), r.initial_area, r.final_area,
          r.final_area_error, r.collapsibility, r.collapsibility_error, impl_->options.git_revision,
          impl_->options.process.host, row.id);
  impl_->record(row.id, JobStatus::running, job.status, row.attempt, job.reason);
}

void Store::replace_intervals(const std::string& study, const std::vector<IntervalRow>& rows) {
  const auto id = impl_->study_id(study);
  SQLite::Statement forget(*impl_->db, "DELETE FROM interval WHERE study_id = ?");
  execute(forget, id);
  SQLite::Statement insert(
      *impl_->db,
      "INSERT INTO interval (study_id, job_id, quantity, unit, value, error, extrapolated_value, "
      "extrapolated_error, observed_order, method, cells, discretisation_error, measuring_error, "
      "measuring_difference, scatter, wanted_error) "
      "SELECT ?, id, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ? FROM job WHERE key = ?");
  for (const auto& r : rows)
    execute(insert, id, r.quantity, r.unit, r.value, r.error, r.extrapolated_value, r.extrapolated_error,
            r.observed_order, r.method, r.cells, r.discretisation_error, r.measuring_error,
            r.measuring_difference, r.scatter, r.wanted_error, r.key);
}

void Store::replace_fits(const std::string& study, const std::vector<FitRow>& fits) {
  const auto id = impl_->study_id(study);
  SQLite::Statement forget(*impl_->db, "DELETE FROM fit WHERE study_id = ?");
  execute(forget, id);
  SQLite::Statement insert(
      *impl_->db,
      "INSERT INTO fit (study_id, position, quantity, against, model, coefficient, value, "
      "standard_error, r2, unit, covariance) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const auto& f : fits)
    execute(insert, id, position++, f.quantity, f.against, f.model, f.coefficient, f.value, f.standard_error,
            f.r2, f.unit,
            f.covariance.empty() ? std::nullopt : std::optional(nlohmann::json(f.covariance).dump()));
}

void Store::replace_critical_speeds(const std::string& study, const std::vector<CriticalSpeedRow>& rows) {
  const auto id = impl_->study_id(study);
  SQLite::Statement forget(*impl_->db, "DELETE FROM critical_speed_bracket WHERE study_id = ?");
  execute(forget, id);
  SQLite::Statement insert(
      *impl_->db,
      "INSERT INTO critical_speed_bracket (study_id, position, wall_thickness_m, lower_m_s, "
      "upper_m_s, lower_key, upper_key, cell_size_m, extrapolated_m_s, interval_m_s, flags, runs) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const auto& b : rows)
    execute(insert, id, b.position, b.wall_thickness, b.lower, b.upper, b.lower_key, b.upper_key, b.cell_size,
            b.extrapolated, b.interval, b.flags, b.runs);
}

void Store::replace_claims(const std::vector<Claim>& claims) {
  impl_->db->exec("DELETE FROM claim");
  SQLite::Statement insert(*impl_->db,
                           "INSERT INTO claim (position, name, sentence, study, measured, verdict, note) "
                           "VALUES (?, ?, ?, ?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const auto& c : claims)
    execute(insert, position++, c.name, c.sentence, c.study, c.measured, c.verdict, c.note);
}

void Store::heartbeat() {
  SQLite::Statement update(*impl_->db, "UPDATE runner SET heartbeat_at = ? WHERE id = ?");
  execute(update, utc_now(), impl_->runner);
}

void Store::leave() {
  SQLite::Statement update(*impl_->db, "UPDATE runner SET ended_at = ? WHERE id = ?");
  execute(update, utc_now(), impl_->runner);
}

}  // namespace mpmstudy
