#include "runner/catalog/reader.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cmath>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/process.hpp"
#include "runner/catalog/runner_row.hpp"
#include "runner/catalog/schema.hpp"
#include "runner/catalog/timestamp.hpp"

namespace mpmstudy {
namespace {

std::string known_names(const std::vector<StudyState>& studies) {
  std::string names;
  for (const auto& study : studies) names += (names.empty() ? "" : ", ") + study.name;
  return names.empty() ? "none" : names;
}

std::vector<StudyState> read_studies(SQLite::Database& db) {
  std::vector<StudyState> studies;
  SQLite::Statement names(db, "SELECT name, title FROM studies ORDER BY name");
  while (names.executeStep())
    studies.push_back({names.getColumn(0).getString(), names.getColumn(1).getString(), {}});
  SQLite::Statement counts(
      db,
      "SELECT s.name, j.status, count(*) FROM study s JOIN study_job m ON m.study_id = s.id "
      "JOIN job j ON j.id = m.job_id GROUP BY s.name, j.status");
  while (counts.executeStep())
    for (auto& study : studies)
      if (study.name == counts.getColumn(0).getString())
        study.jobs[job_status_from(counts.getColumn(1).getString())] = counts.getColumn(2).getInt64();
  return studies;
}

/// A job that a study once had keeps its row: it is reused when one has it again.
StudyState read_no_study(SQLite::Database& db) {
  StudyState none;
  SQLite::Statement counts(
      db, "SELECT status, count(*) FROM job WHERE id NOT IN (SELECT job_id FROM study_job) GROUP BY status");
  while (counts.executeStep())
    none.jobs[job_status_from(counts.getColumn(0).getString())] = counts.getColumn(1).getInt64();
  return none;
}

/// The studies of `job j`, coarser cells included.
constexpr std::string_view of_studies =
    "LEFT JOIN study_job m ON m.job_id = j.id LEFT JOIN study s ON s.id = m.study_id ";

/// Whether a process may still run. One that cannot be looked for from here is taken to run if its last sign
/// of life is less than ten minutes old, by its own clock or by this one. Only for display: no job is taken
/// from a process for this reason.
bool may_live(const RunnerRow& runner) {
  constexpr double recent_s = 600;
  return runner.gone.empty() &&
         (runner.last_sign.empty() || std::abs(seconds_between(runner.last_sign, utc_now())) < recent_s);
}

CatalogState read_all(SQLite::Database& db) {
  CatalogState state;
  SQLite::Transaction one_moment(db);
  state.studies = read_studies(db);
  state.no_study = read_no_study(db);
  state.stale = db.execAndGet("SELECT count(*) FROM job WHERE " + stale_sql()).getInt64();
  const bool old = db.execAndGet("PRAGMA user_version").getInt() < 7;
  const std::string columns(old ? runner_columns_before_7 : runner_columns);
  SQLite::Statement processes(db, "SELECT " + columns + " FROM runner r WHERE r.ended_at IS NULL");
  while (processes.executeStep()) state.processes += may_live(runner_row(processes, 0));
  SQLite::Statement running(db, "SELECT j.key, s.name, j.started_at, j.attempt, " + columns +
                                    " FROM job j JOIN runner r ON r.id = j.runner_id " +
                                    std::string(of_studies) +
                                    "WHERE j.status = 'running' ORDER BY j.started_at, j.key, s.name");
  while (running.executeStep()) {
    const auto by = runner_row(running, 4);
    state.running.push_back({running.getColumn(0).getString(), running.getColumn(1).getString(), by.who,
                             running.getColumn(2).getString(), running.getColumn(3).getInt64(), by.gone,
                             by.last_sign});
  }
  SQLite::Statement failed(db, "SELECT j.key, s.name, j.reason FROM job j " + std::string(of_studies) +
                                   "WHERE j.status = 'failed' ORDER BY s.name, m.position, j.key");
  while (failed.executeStep())
    state.failed.push_back(
        {failed.getColumn(0).getString(), failed.getColumn(1).getString(), failed.getColumn(2).getString()});
  return state;
}

}  // namespace

CatalogState read_state(const std::filesystem::path& results, const std::vector<std::string>& wanted) {
  const auto db = open_for_reading(results);
  CatalogState state;
  try {
    state = read_all(*db);
    const auto is_gone = [](const RunningJob& job) { return !job.gone.empty(); };
    // A process that decides its last job and ends between the reading and the look at it has not gone.
    if (std::ranges::any_of(state.running, is_gone)) state = read_all(*db);
  } catch (const SQLite::Exception& error) {
    throw CatalogError(catalog_path(results).string() + ": cannot be read (" + error.what() + ")");
  }
  if (wanted.empty()) return state;
  for (const auto& name : wanted)
    if (std::ranges::none_of(state.studies, [&](const auto& study) { return study.name == name; }))
      throw CatalogError(catalog_path(results).string() + ": there is no study '" + name +
                         "'; known: " + known_names(state.studies));
  const auto is_other = [&](const std::string& name) {
    return std::ranges::find(wanted, name) == wanted.end();
  };
  std::erase_if(state.studies, [&](const auto& study) { return is_other(study.name); });
  state.no_study = {};
  std::erase_if(state.running, [&](const auto& job) { return is_other(job.study); });
  std::erase_if(state.failed, [&](const auto& job) { return is_other(job.study); });
  return state;
}

/// The place of a column's word in its choice; the first where there is none, as before there was the choice.
static std::size_t word_at(const SQLite::Column& column, std::string_view choice) {
  const auto& words = mpm::find_choice(choice)->allowed;
  const auto at = std::ranges::find(words, column.isNull() ? words[0] : std::string_view(column.getText()));
  return at == words.end() ? 0 : static_cast<std::size_t>(at - words.begin());
}

std::vector<CostSample> measured_costs(const std::filesystem::path& results) {
  std::vector<CostSample> samples;
  std::error_code ignored;
  if (!std::filesystem::exists(catalog_path(results), ignored)) return samples;
  try {
    const auto db = open_for_reading(results);
    SQLite::Statement rows(
        *db,
        "SELECT predicted_particles, predicted_steps, cpu_s, coalesce((SELECT min(study_id) "
        "FROM study_job WHERE job_id = id), ''), space, kernel FROM job "
        "WHERE status = 'done' AND host = ? ORDER BY id DESC LIMIT 1000");
    rows.bind(1, this_process().host);
    while (rows.executeStep())
      samples.push_back({rows.getColumn(0).getDouble(), rows.getColumn(1).getDouble(),
                         rows.getColumn(2).getDouble(), rows.getColumn(3).getString(),
                         mpm::update_cost(static_cast<mpm::Space>(word_at(rows.getColumn(4), "space")),
                                          static_cast<mpm::Kernel>(word_at(rows.getColumn(5), "kernel")))});
  } catch (const UnfinishedCatalog&) {
  } catch (const SQLite::Exception&) {  // an older layout: run will bring it up to date
    samples.clear();
  }
  return samples;
}

}  // namespace mpmstudy
