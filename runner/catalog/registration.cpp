// Registering a study: what it wants against what the catalog has. Failed jobs that are planned again.
#include <nlohmann/json.hpp>
#include <tuple>

#include "libmpm/scene/physics_version.hpp"
#include "runner/catalog/runner_row.hpp"
#include "runner/catalog/store_impl.hpp"
#include "runner/plan/composition_text.hpp"
#include "runner/plan/gauge_text.hpp"
#include "runner/study/decimal.hpp"

namespace mpmstudy {

std::int64_t Store::Impl::add_job(const Job& job) {
  const auto& scene = job.scene;
  insert_job.tryReset();
  int i = 0;
  const auto bind = [&](const auto& value) { bind_one(insert_job, ++i, value); };
  bind(job.key);
  bind(std::string(mpm::to_string(scene.kind)));
  bind(scene.material.name);
  bind(nlohmann::json(scene.measures.snapshots).dump());
  bind(mpm::physics_version_of(scene));
  bind(job.estimate.particles);
  bind(job.estimate.steps);
  bind(job.predicted_seconds);
  const auto& gauges = scene.measures.gauges;
  bind(gauges.empty() ? std::nullopt : std::optional(gauges_text(gauges)));
  nlohmann::ordered_json exact;
  for (const auto& q : mpm::quantities()) {
    if (!q.belongs_to(scene.kind)) {
      bind(std::optional<double>());
      continue;
    }
    const double value = q.get(scene), written = without_rounding(value);
    bind(written);
    if (written != value && !q.derived) exact[std::string(q.column)] = value;
  }
  for (const auto& c : mpm::choices())
    bind(c.belongs_to(scene.kind) ? std::optional(std::string(c.allowed[c.get(scene)]))
                                  : std::optional<std::string>());
  bind(exact.is_null() ? std::nullopt : std::optional(exact.dump()));
  bind(or_null(composition_text(scene)));
  insert_job.exec();
  const std::int64_t id = db->getLastInsertRowid();
  record(id, std::nullopt, JobStatus::planned, 0);
  return id;
}

/// What the study calls its own, with the values of this job.
void Store::Impl::enter_labels(std::int64_t study, std::int64_t job, const mpm::Scene& scene) {
  for (const mpm::Label& label : scene.labels)
    execute(insert_label, study, job, label.name, without_rounding(label.value), label.unit);
}

std::optional<Store::Impl::Row> Store::Impl::find(const Job& job) {
  if (auto row = find(job.key)) return row;
  const std::string former = former_key(job.scene);
  if (former == job.key) return std::nullopt;
  const auto row = find(former);
  if (!row || row->status == JobStatus::running) return row;  // its process uses that key
  SQLite::Statement rename(*db, "UPDATE job SET key = ?, former_key = ? WHERE id = ?");
  execute(rename, job.key, former, row->id);
  record(row->id, row->status, row->status, row->attempt,
         "its key was " + former + " while a parameter without an effect was part of it");
  return row;
}

/// running -> planned. The job may be what its process died of: that is counted.
void Store::Impl::take_from(std::int64_t job, std::int64_t attempt, const std::string& who) {
  execute(plan_again, job);
  execute(add_crash, job);
  record(job, JobStatus::running, JobStatus::planned, attempt, "process " + who + " is gone");
}

std::map<std::int64_t, std::string> Store::Impl::gone_runners() {
  std::map<std::int64_t, std::string> gone;
  SQLite::Statement runners(*db, "SELECT " + std::string(runner_columns) +
                                     " FROM runner r WHERE r.id <> ? AND "
                                     "r.id IN (SELECT runner_id FROM job WHERE status = 'running')");
  runners.bind(1, runner);
  while (runners.executeStep())
    if (const auto other = runner_row(runners, 0, &heartbeats); !other.gone.empty())
      gone[runners.getColumn(0).getInt64()] = other.who;
  return gone;
}

std::set<std::int64_t> Store::Impl::take_up() {
  std::set<std::int64_t> taken;
  for (const auto& [id, who] : gone_runners()) {
    std::vector<std::pair<std::int64_t, std::int64_t>> jobs;  // id, attempt
    SQLite::Statement left(*db, "SELECT id, attempt FROM job WHERE status = 'running' AND runner_id = ?");
    left.bind(1, id);
    while (left.executeStep()) jobs.emplace_back(left.getColumn(0).getInt64(), left.getColumn(1).getInt64());
    for (const auto& [job, attempt] : jobs) {
      take_from(job, attempt, who);
      taken.insert(job);
    }
  }
  return taken;
}

bool Store::Impl::take_up(const Row& row) {
  if (row.runner == runner) return false;
  SQLite::Statement found(*db, "SELECT " + std::string(runner_columns) + " FROM runner r WHERE r.id = ?");
  found.bind(1, row.runner);
  if (!found.executeStep()) return false;
  const auto other = runner_row(found, 0, &heartbeats);
  if (other.gone.empty()) return false;
  take_from(row.id, row.attempt, other.who);
  return true;
}

void Store::Impl::cancel_unwanted() {
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

namespace {

/// The jobs that a study has, in order of position; a large study that is done is read once, not asked for
/// job by job.
std::vector<std::pair<std::string, Store::Impl::Row>> members_of(SQLite::Database& db, std::int64_t study) {
  std::vector<std::pair<std::string, Store::Impl::Row>> members;
  SQLite::Statement rows(db,
                         "SELECT j.key, j.id, j.status, j.attempt, j.runner_id, j.crashes FROM study_job m "
                         "JOIN job j ON j.id = m.job_id WHERE m.study_id = ? ORDER BY m.position");
  rows.bind(1, study);
  while (rows.executeStep())
    members.push_back(
        {rows.getColumn(0).getString(),
         {rows.getColumn(1).getInt64(), job_status_from(rows.getColumn(2).getString()),
          rows.getColumn(3).getInt64(), rows.getColumn(4).getInt64(), rows.getColumn(5).getInt64()}});
  return members;
}

/// Fits, intervals and brackets of other --set or --cells are not those of the study as it is now.
void forget_another_form(SQLite::Database& db, const std::string& name, const StudySource& source) {
  for (const char* table : {"fit", "interval", "bracket"}) {
    SQLite::Statement forget(db, std::string("DELETE FROM ") + table +
                                     " WHERE study_id = (SELECT id FROM study WHERE name = ?1 AND (overrides "
                                     "IS NOT ?2 OR cells <> ?3))");
    forget.bind(1, name);
    forget.bind(2, nlohmann::json(source.set).dump());
    forget.bind(3, source.cells);
    forget.exec();
  }
}

/// Has the study every job that is not a coarser or finer cell of another?
bool has_all(const std::vector<std::pair<std::string, Store::Impl::Row>>& members,
             const std::vector<Job>& jobs) {
  std::set<std::string> keys;
  for (const auto& [key, row] : members) keys.insert(key);
  return std::ranges::all_of(jobs, [&](const Job& job) { return job.rung_of || keys.contains(job.key); });
}

/// Behind all that the study has.
std::int64_t next_position(SQLite::Database& db, std::int64_t study) {
  SQLite::Statement last(db, "SELECT coalesce(max(position) + 1, 0) FROM study_job WHERE study_id = ?");
  last.bind(1, study);
  last.executeStep();
  return last.getColumn(0).getInt64();
}

std::int64_t enter_study(SQLite::Database& db, const std::string& name, const std::string& title,
                         const StudySource& source) {
  forget_another_form(db, name, source);
  SQLite::Statement upsert(
      db,
      "INSERT INTO study (name, title, updated_at, path, overrides, cells) VALUES (?, ?, ?, ?, ?, ?) "
      "ON CONFLICT (name) DO UPDATE SET title = excluded.title, updated_at = excluded.updated_at, "
      "path = excluded.path, overrides = excluded.overrides, cells = excluded.cells RETURNING id");
  upsert.bind(1, name);
  upsert.bind(2, title);
  upsert.bind(3, utc_now());
  bind_one(upsert, 4, or_null(source.path));
  upsert.bind(5, nlohmann::json(source.set).dump());
  upsert.bind(6, source.cells);
  upsert.executeStep();
  return upsert.getColumn(0).getInt64();
}

}  // namespace

Registration Store::register_study(const std::string& name, const std::string& title,
                                   const std::vector<Job>& jobs, bool retry_failed, const StudySource& source,
                                   const Selection& selection) {
  auto& db = *impl_->db;
  const std::int64_t study = enter_study(db, name, title, source);
  const auto taken_up = impl_->take_up();
  const auto members = members_of(db, study);
  const bool ladders = std::ranges::any_of(jobs, [](const Job& job) { return job.rung_of.has_value(); });
  const bool same =
      !ladders && std::ranges::equal(jobs, members, {}, &Job::key, [](const auto& m) { return m.first; });
  const bool keep = selection.members == Members::also ||
                    (selection.members == Members::at_least && has_all(members, jobs));
  if (!same && !keep) {
    SQLite::Statement forget(db, "DELETE FROM study_job WHERE study_id = ?");
    execute(forget, study);
  }
  if (!keep) {
    SQLite::Statement forget(db, "DELETE FROM own_parameter WHERE study_id = ?");
    execute(forget, study);
  }
  std::vector<Impl::Row> rows;
  rows.reserve(jobs.size());
  std::int64_t position = selection.members == Members::also ? next_position(db, study) : 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (same) {
      rows.push_back(members[i].second);
      impl_->enter_labels(study, rows.back().id, jobs[i].scene);
      continue;
    }
    const auto row = impl_->find(jobs[i]);
    rows.push_back(row ? *row : Impl::Row{.id = impl_->add_job(jobs[i])});
    const auto& rung_of = jobs[i].rung_of;
    execute(impl_->insert_member, study, rows.back().id, rung_of ? *rung_of : position++, rung_of ? 1 : 0,
            or_null(jobs[i].reason));
    impl_->enter_labels(study, rows.back().id, jobs[i].scene);
  }

  const auto damaged = impl_->damaged_jobs(study);
  Registration registration;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto [id, status, attempt, runner, crashes] = rows[i];
    std::string again;  // why, if so
    if (status == JobStatus::cancelled) again = "wanted again";
    if (status == JobStatus::failed && retry_failed && selection.retries(jobs[i].key))
      again = "retry of a failed job";
    if (const auto found = damaged.find(id); found != damaged.end()) {
      again = found->second;
      ++registration.damaged;
    }
    if (!again.empty()) {
      execute(impl_->plan_again, id);
      impl_->record(id, status, JobStatus::planned, attempt, again);
    }
    const auto now = again.empty() ? status : JobStatus::planned;
    registration.states.push_back(now);
    if (now == JobStatus::planned) {
      registration.to_run.push_back(jobs[i].key);
      registration.taken_up += taken_up.contains(id);
    } else if (now == JobStatus::done) {
      ++registration.done;
    } else if (now == JobStatus::failed) {
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
  const auto row = impl_->find(rung);
  const auto job = row ? row->id : impl_->add_job(rung);
  auto status = row ? row->status : JobStatus::planned;
  if (status == JobStatus::cancelled || (status == JobStatus::failed && retry_failed)) {
    execute(impl_->plan_again, job);
    impl_->record(job, status, JobStatus::planned, row->attempt,
                  status == JobStatus::failed ? "retry of a failed job" : "wanted again");
    status = JobStatus::planned;
  }
  SQLite::Statement coarser(*impl_->db,
                            "UPDATE study_job SET coarse = 1 WHERE study_id = ? AND position = ?");
  execute(coarser, id, rung.rung_of);
  execute(impl_->insert_member, id, job, rung.rung_of, 0, or_null(rung.reason));
  impl_->enter_labels(id, job, rung.scene);
  return status;
}

std::vector<std::string> Store::retry(const RetryFilter& filter) {
  SQLite::Statement rows(
      *impl_->db,
      "SELECT id, attempt, key FROM job WHERE status = 'failed' AND key >= ?1 AND key < ?2 "
      "AND (?3 = '' OR failure_kind = ?3) AND (?4 = '' OR EXISTS (SELECT 1 FROM study_job m "
      "JOIN study s ON s.id = m.study_id WHERE m.job_id = job.id AND s.name = ?4)) ORDER BY id");
  rows.bind(1, filter.key_begins);
  rows.bind(2, filter.key_begins + "g");  // behind every hexadecimal digit
  rows.bind(3, filter.kind);
  rows.bind(4, filter.study);
  std::vector<std::tuple<std::int64_t, std::int64_t, std::string>> jobs;
  while (rows.executeStep())
    jobs.emplace_back(rows.getColumn(0).getInt64(), rows.getColumn(1).getInt64(),
                      rows.getColumn(2).getString());
  std::vector<std::string> keys;
  for (const auto& [id, attempt, key] : jobs) {
    execute(impl_->plan_again, id);
    impl_->record(id, JobStatus::failed, JobStatus::planned, attempt, "retry asked for");
    keys.push_back(key);
  }
  return keys;
}

}  // namespace mpmstudy
