#include "runner/catalog/stored_jobs.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/plan/composition_text.hpp"
#include "runner/plan/gauge_text.hpp"

namespace mpmstudy {
namespace {

/// Columns from `first` on: every row of the parameter table that is no product of others, then the choices.
/// Numbers that do not stand there with all their digits are in column `exact` as well.
mpm::Scene scene_from(SQLite::Statement& row, int exact_column, int first) {
  mpm::Scene scene;
  const auto kind = mpm::scene_kind_from(row.getColumn(1).getString());
  if (!kind) throw CatalogError("catalog: '" + row.getColumn(1).getString() + "' is no kind of scene");
  scene.kind = *kind;
  scene.material.name = row.getColumn(2).getString();
  scene.measures.snapshots = nlohmann::json::parse(row.getColumn(3).getString()).get<std::vector<double>>();
  const auto exact = row.isColumnNull(exact_column)
                         ? nlohmann::json::object()
                         : nlohmann::json::parse(row.getColumn(exact_column).getString());
  int i = first;
  for (const auto& q : mpm::quantities()) {
    const int column = i++;
    if (!q.derived && q.belongs_to(*kind) && !row.isColumnNull(column))
      q.set(scene, exact.value(std::string(q.column), row.getColumn(column).getDouble()));
  }
  for (const auto& c : mpm::choices()) {
    const int column = i++;
    if (!c.belongs_to(*kind)) continue;
    const auto word = row.getColumn(column).getString();
    const auto found = std::ranges::find(c.allowed, word);
    if (found != c.allowed.end()) c.set(scene, static_cast<std::size_t>(found - c.allowed.begin()));
  }
  return scene;
}

std::string select_sql() {
  std::string sql =
      "SELECT j.key, j.scene, j.material, j.snapshot_times, j.status, j.reason, j.failure_kind, j.attempt, "
      "j.crashes, j.steps, j.physics_version, j.id, j.predicted_particles, j.predicted_steps, j.predicted_s, "
      "j.exact, j.gauges, j.composition";
  for (const auto& q : mpm::quantities()) sql += ", j.\"" + std::string(q.column) + "\"";
  for (const auto& c : mpm::choices()) sql += ", j.\"" + std::string(c.column) + "\"";
  return sql +
         " FROM job j WHERE ((j.key >= ?1 AND j.key < ?2) OR (j.former_key >= ?1 AND j.former_key < ?2)) "
         "AND (?3 = '' OR j.status = ?3) ORDER BY j.id";
}

template <class Read>
auto reading(const std::filesystem::path& results, Read read) {
  const auto db = open_for_reading(results);
  try {
    return read(*db);
  } catch (const SQLite::Exception& error) {
    throw CatalogError(catalog_path(results).string() + ": cannot be read (" + error.what() +
                       "); `mpmstudy run STUDY` brings a catalog of an older program up to date");
  } catch (const std::invalid_argument& error) {  // of gauges or bodies
    throw CatalogError(catalog_path(results).string() + ": is damaged: " + error.what());
  } catch (const nlohmann::json::exception& error) {
    throw CatalogError(catalog_path(results).string() + ": is damaged (" + error.what() + ")");
  }
}

}  // namespace

std::vector<StoredJob> read_jobs(const std::filesystem::path& results, const JobFilter& filter) {
  return reading(results, [&](SQLite::Database& db) {
    std::vector<StoredJob> jobs;
    SQLite::Statement rows(db, select_sql());
    rows.bind(1, filter.key_begins);
    rows.bind(2, filter.key_begins + "g");  // behind every hexadecimal digit
    rows.bind(3, filter.status);
    while (rows.executeStep()) {
      StoredJob stored;
      stored.job.key = rows.getColumn(0).getString();
      stored.job.scene = scene_from(rows, 15, 18);
      if (!rows.isColumnNull(16))
        stored.job.scene.measures.gauges = gauges_from_text(rows.getColumn(16).getString());
      if (!rows.isColumnNull(17)) set_composition(stored.job.scene, rows.getColumn(17).getString());
      stored.status = job_status_from(rows.getColumn(4).getString());
      stored.reason = rows.getColumn(5).getString();
      stored.failure_kind = rows.getColumn(6).getString();
      stored.attempt = rows.getColumn(7).getInt64();
      stored.crashes = rows.getColumn(8).getInt64();
      stored.steps = rows.getColumn(9).getInt64();
      stored.physics_version = rows.getColumn(10).getInt();
      stored.order = rows.getColumn(11).getInt64();
      stored.job.estimate = {rows.getColumn(12).getInt64(), rows.getColumn(13).getInt64()};
      stored.job.predicted_seconds = rows.getColumn(14).getDouble();
      jobs.push_back(std::move(stored));
    }
    return jobs;
  });
}

std::vector<StoredStudy> read_studies(const std::filesystem::path& results) {
  return reading(results, [](SQLite::Database& db) {
    std::vector<StoredStudy> studies;
    SQLite::Statement rows(db, "SELECT name, path, overrides, cells FROM study ORDER BY name");
    while (rows.executeStep()) {
      StoredStudy study{rows.getColumn(0).getString(),
                        {rows.getColumn(1).getString(), {}, rows.getColumn(3).getDouble()}};
      if (!rows.isColumnNull(2))
        study.source.set =
            nlohmann::json::parse(rows.getColumn(2).getString()).get<std::vector<std::string>>();
      studies.push_back(std::move(study));
    }
    return studies;
  });
}

}  // namespace mpmstudy
