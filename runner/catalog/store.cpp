#include <nlohmann/json.hpp>

#include "runner/catalog/store_impl.hpp"
#include "runner/study/decimal.hpp"

namespace mpmstudy {

void Store::Impl::write_result(std::int64_t id, const FinishedJob& job, const std::string& finished_at,
                               const std::string& host, const std::string& git_revision) {
  const auto& r = job.result;
  execute(delete_metrics, id);
  execute(delete_area, id);
  execute(delete_gauges, id);
  execute(delete_history_samples, id);
  execute(delete_snapshots, id);
  for (const auto& m : r.metrics) execute(insert_metric, id, m.name, m.value, m.unit, m.error);
  std::int64_t sample = 0;
  for (const auto& a : r.area_history) execute(insert_area, id, sample++, a.time, a.area, a.void_area);
  for (std::size_t g = 0; g < r.histories.size(); ++g) {
    const mpm::History& h = r.histories[g];
    const auto gauge = static_cast<std::int64_t>(g);
    execute(insert_gauge, id, gauge, h.name, h.unit);
    for (std::size_t k = 0; k < h.times.size(); ++k)
      execute(insert_history_sample, id, gauge, static_cast<std::int64_t>(k), h.times[k], h.values[k]);
  }
  for (const auto& s : job.snapshots)
    execute(insert_snapshot, id, s.time, s.step, s.path, s.bytes, s.checksum,
            s.modified_ns == 0 ? std::nullopt : std::optional(s.modified_ns));
  const auto kind = job.failure ? std::optional(std::string(to_string(*job.failure))) : std::nullopt;
  execute(end, std::string(to_string(job.status)), or_null(job.reason), kind, finished_at, r.particles,
          r.steps, job.wall_s, job.cpu_s, r.energy_error, or_null(r.outcome), r.initial_area, r.final_area,
          r.final_area_error, r.collapsibility, r.collapsibility_error, git_revision, host, id);
}

Store::Store(const std::filesystem::path& results, StoreOptions options)
    : impl_(std::make_unique<Impl>(results, std::move(options))) {
  begin();
  impl_->enter();
  impl_->db->exec("UPDATE physics SET version = max(version, " + std::to_string(mpm::physics_version) + ")");
  commit();
}

Store::~Store() = default;

void Store::begin() { impl_->db->exec("BEGIN IMMEDIATE"); }
void Store::commit() { impl_->db->exec("COMMIT"); }
void Store::rollback() { impl_->db->tryExec("ROLLBACK"); }
void Store::begin_part() { impl_->db->exec("SAVEPOINT part"); }
void Store::commit_part() { impl_->db->exec("RELEASE part"); }
void Store::rollback_part() { impl_->db->exec("ROLLBACK TO part; RELEASE part"); }

JobReservation Store::reserve(const std::string& key) {
  auto row = impl_->find(key);
  if (!row) return {};
  if (row->status == JobStatus::running && impl_->take_up(*row)) row = impl_->find(key);
  if (row->status != JobStatus::planned) return {false, row->status, row->crashes};
  execute(impl_->start, impl_->runner, utc_now(), row->id);
  impl_->record(row->id, JobStatus::planned, JobStatus::running, row->attempt + 1);
  impl_->reserved.insert(key);
  impl_->held.insert(key);
  return {true, JobStatus::running, row->crashes};
}

std::int64_t Store::crashed(const std::string& key) {
  const auto row = impl_->find_mine(key);
  if (!row) return 0;
  execute(impl_->add_crash, row->id);
  return row->crashes + 1;
}

void Store::release(const std::string& key, const std::string& reason) {
  impl_->held.erase(key);
  const auto row = impl_->find_mine(key);
  if (!row) return;
  execute(impl_->plan_again, row->id);
  impl_->record(row->id, JobStatus::running, JobStatus::planned, row->attempt, reason);
}

bool Store::complete(const FinishedJob& job) {
  impl_->held.erase(job.key);
  const auto row = impl_->find_mine(job.key);
  if (!row) return false;
  impl_->write_result(row->id, job, utc_now(), impl_->options.process.host, impl_->options.git_revision);
  impl_->record(row->id, JobStatus::running, job.status, row->attempt, job.reason);
  return true;
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
      "standard_error, r2, unit, covariance, reduced_chi2, points, family) VALUES (?, ?, ?, ?, ?, ?, ?, ?, "
      "?, ?, ?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const auto& f : fits)
    execute(insert, id, position++, f.quantity, f.against, f.model, f.coefficient, f.value, f.standard_error,
            f.r2, f.unit,
            f.covariance.empty() ? std::nullopt : std::optional(nlohmann::json(f.covariance).dump()),
            f.reduced_chi2, f.points, f.family);
}

void Store::replace_brackets(const std::string& study, const std::vector<BracketRow>& rows) {
  const auto id = impl_->study_id(study);
  SQLite::Statement forget(*impl_->db, "DELETE FROM bracket WHERE study_id = ?");
  execute(forget, id);
  SQLite::Statement insert(
      *impl_->db,
      "INSERT INTO bracket (study_id, position, quantity, unit, lower, upper, lower_key, "
      "upper_key, cell_size_m, extrapolated, interval, flags, runs, swept, "
      "wall_thickness_m, exact_lower, exact_upper) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
      "?)");
  const auto plain = [](std::optional<double> end) {
    return end ? std::optional(without_rounding(*end)) : std::nullopt;
  };
  for (const auto& b : rows)
    execute(insert, id, b.position, b.quantity, b.unit, plain(b.lower), plain(b.upper), or_null(b.lower_key),
            or_null(b.upper_key), without_rounding(b.cell_size), b.extrapolated, b.interval, b.flags, b.runs,
            b.swept, b.wall_thickness, b.lower, b.upper);
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
  SQLite::Statement update(*impl_->db, "UPDATE runner SET heartbeat_at = ?, beats = beats + 1 WHERE id = ?");
  execute(update, utc_now(), impl_->runner);
  impl_->gone_runners();
}

bool Store::holds(const std::string& key) { return impl_->find_mine(key).has_value(); }

std::vector<std::string> Store::lost() {
  std::vector<std::string> keys;
  for (const auto& key : impl_->held)
    if (!impl_->find_mine(key)) keys.push_back(key);
  for (const auto& key : keys) impl_->held.erase(key);
  return keys;
}

void Store::move_log() noexcept { impl_->db->tryExec("PRAGMA wal_checkpoint(PASSIVE)"); }

void Store::leave() {
  SQLite::Statement update(*impl_->db, "UPDATE runner SET ended_at = ? WHERE id = ?");
  execute(update, utc_now(), impl_->runner);
}

}  // namespace mpmstudy
