// The views of a catalog (README.md), over the tables of schema.cpp.
#include "libmpm/measure/results.hpp"
#include "libmpm/scene/physics_version.hpp"
#include "runner/catalog/schema.hpp"

namespace mpmstudy {
namespace {

/// Half width of an interval that holds all that a collapsibility can be, 0 to 1, from its middle.
constexpr const char* widest_interval = "0.5";
/// A final area is a mean over the last quarter of a run: a cavity that closes late has so much of its
/// initial area left in it.
constexpr const char* room_of_collapsed = "0.1";

constexpr std::string_view jobs_before = R"sql(
DROP VIEW IF EXISTS jobs;
CREATE VIEW jobs AS SELECT
  j.key AS key, s.name AS study, j.status AS status, j.reason AS reason,
)sql";

constexpr std::string_view jobs_after = R"sql(
  j.particles AS particles, j.steps AS steps, j.wall_s AS wall_s, j.cpu_s AS cpu_s,
  j.energy_error AS energy_error, j.outcome AS outcome, j.initial_area_m2 AS initial_area_m2,
  j.final_area_m2 AS final_area_m2,
  @error of final_area_m2@ AS final_area_error_m2,
  j.collapsibility AS collapsibility,
  @error of collapsibility@ AS collapsibility_error,
  j.physics_version AS physics_version, j.git_revision AS git_revision, j.host AS host,
  j.scene AS scene, j.material AS material, m.position AS position, j.attempt AS attempt,
  j.started_at AS started_at, j.finished_at AS finished_at, j.predicted_s AS predicted_s,
  CAST(j.particles AS REAL) * j.steps / nullif(j.cpu_s, 0) AS particle_updates_per_s,
  j.failure_kind AS failure_kind, j.crashes AS crashes,
  @stale@ AS stale,
  CASE WHEN j.final_area_m2 IS NULL THEN NULL
    WHEN EXISTS (SELECT 1 FROM metric c WHERE c.job_id = j.id AND c.name = 'cavity_joined_outside_time_s')
      THEN 'cavity open to the outside: its final area has no meaning'
    WHEN EXISTS (SELECT 1 FROM metric c WHERE c.job_id = j.id AND c.name = 'cavity_closed_time_s')
      AND (SELECT c.value FROM metric c WHERE c.job_id = j.id AND c.name = 'final_void_area_m2') > 0
      THEN 'cavity closed, then torn open: its final area has no meaning'
    WHEN j.collapsibility < 0 THEN 'cavity larger than at the start: its final area has no meaning'
    WHEN @error of collapsibility@ >= @widest@
      THEN 'interval as wide as what a collapsibility can be (0 to 1): the final area has no meaning'
    WHEN j.outcome = 'collapsed' AND 1 - j.collapsibility - @error of collapsibility@ > @room@
      THEN 'outcome collapsed, but the final area is not 0 within its interval: they contradict each other'
    WHEN j.outcome = 'partial' AND j.collapsibility - @error of collapsibility@ > 1
      THEN 'outcome partial, but the final area is below 0 beyond its interval: they contradict each other'
    ELSE '' END AS flags
FROM job j
LEFT JOIN study_job m ON m.job_id = j.id AND m.coarse = 0
LEFT JOIN study s ON s.id = m.study_id;
)sql";

constexpr std::string_view other_views = R"sql(
DROP VIEW IF EXISTS metrics;
CREATE VIEW metrics AS SELECT j.key AS key, c.name AS name, c.value AS value, c.unit AS unit,
  coalesce((SELECT i.error FROM interval i WHERE i.job_id = j.id AND i.quantity = c.name
            ORDER BY i.cells DESC, i.study_id LIMIT 1), c.error) AS error
FROM job j JOIN metric c ON c.job_id = j.id;

DROP VIEW IF EXISTS area_history;
CREATE VIEW area_history AS SELECT j.key AS key, c.time_s AS time_s, c.area_m2 AS area_m2,
  c.void_area_m2 AS void_area_m2
FROM job j JOIN area_sample c ON c.job_id = j.id;

DROP VIEW IF EXISTS history;
CREATE VIEW history AS SELECT j.key AS key, g.name AS name, c.time_s AS time_s, c.value AS value, g.unit AS unit
FROM job j JOIN gauge g ON g.job_id = j.id
JOIN history_sample c ON c.job_id = g.job_id AND c.gauge = g.gauge;

DROP VIEW IF EXISTS snapshots;
CREATE VIEW snapshots AS SELECT j.key AS key, c.time_s AS time_s, c.path AS path, c.bytes AS bytes,
  c.checksum AS checksum, c.step AS step
FROM job j JOIN snapshot c ON c.job_id = j.id;

DROP VIEW IF EXISTS events;
CREATE VIEW events AS SELECT j.key AS key, e.from_status AS from_status, e.to_status AS to_status, e.at AS at,
  r.host || ':' || r.pid AS "by", e.attempt AS attempt, e.reason AS reason, e.id AS id
FROM event e JOIN job j ON j.id = e.job_id JOIN runner r ON r.id = e.runner_id;

DROP VIEW IF EXISTS decisions;
CREATE VIEW decisions AS SELECT s.name AS study, j.key AS key, m.position AS position, m.reason AS reason
FROM study_job m JOIN study s ON s.id = m.study_id JOIN job j ON j.id = m.job_id;

DROP VIEW IF EXISTS parameters;
CREATE VIEW parameters AS SELECT s.name AS study, j.key AS key, p.name AS name, p.value AS value, p.unit AS unit
FROM own_parameter p JOIN study s ON s.id = p.study_id JOIN job j ON j.id = p.job_id;

DROP VIEW IF EXISTS studies;
CREATE VIEW studies AS SELECT name, title, updated_at, path, overrides, cells FROM study;

DROP VIEW IF EXISTS claims;
CREATE VIEW claims AS SELECT name, sentence, verdict, measured, note, study FROM claim;

DROP VIEW IF EXISTS fits;
CREATE VIEW fits AS SELECT s.name AS study, f.quantity AS quantity, f.model AS model,
  f.coefficient AS coefficient, f.value AS value, f.standard_error AS standard_error, f.r2 AS r2,
  f.unit AS unit, f.against AS against, f.covariance AS covariance, f.reduced_chi2 AS reduced_chi2,
  f.points AS points, f.family AS family
FROM study s JOIN fit f ON f.study_id = s.id;

DROP VIEW IF EXISTS brackets;
CREATE VIEW brackets AS SELECT s.name AS study, b.quantity AS quantity, b.unit AS unit,
  b.lower AS lower, b.upper AS upper, b.lower_key AS lower_key, b.upper_key AS upper_key,
  b.cell_size_m AS cell_size_m,
  b.extrapolated AS extrapolated, b.interval AS interval, b.flags AS flags, b.runs AS runs,
  b.position AS position, b.swept AS swept
FROM study s JOIN bracket b ON b.study_id = s.id;

DROP VIEW IF EXISTS critical_speed;
CREATE VIEW critical_speed AS SELECT s.name AS study, b.wall_thickness_m AS wall_thickness_m,
  b.lower AS lower_m_s, b.upper AS upper_m_s, b.lower_key AS lower_key,
  b.upper_key AS upper_key, b.cell_size_m AS cell_size_m, b.extrapolated AS extrapolated_m_s, b.interval AS interval_m_s,
  b.flags AS flags, b.runs AS runs, b.position AS position
FROM study s JOIN bracket b ON b.study_id = s.id WHERE b.unit = 'm/s';

DROP VIEW IF EXISTS accuracy;
CREATE VIEW accuracy AS SELECT s.name AS study, j.key AS key, i.quantity AS quantity, i.value AS value,
  i.unit AS unit, i.error AS error, i.extrapolated_value AS extrapolated_value,
  i.extrapolated_error AS extrapolated_error, i.observed_order AS observed_order, i.method AS method, i.cells AS cells,
  i.discretisation_error AS discretisation_error, i.measuring_error AS measuring_error,
  i.measuring_difference AS measuring_difference, i.scatter AS scatter,
  i.wanted_error AS wanted_error, i.extrapolated_error <= i.wanted_error AS reached
FROM interval i JOIN study s ON s.id = i.study_id JOIN job j ON j.id = i.job_id;

)sql";

/// The half width that a study has of a number, else the one from the most cells, else what the job measured.
std::string error_of(const mpm::ResultRow& result) {
  const std::string of_it =
      "FROM interval i WHERE i.job_id = j.id AND i.quantity = '" + std::string(result.name) + "'";
  return "coalesce((SELECT i.error " + of_it + " AND i.study_id = m.study_id), (SELECT i.error " + of_it +
         " ORDER BY i.cells DESC, i.study_id LIMIT 1), j." + std::string(result.error_column) + ")";
}

void replace_all(std::string& sql, std::string_view what, const std::string& with) {
  for (auto at = sql.find(what); at != std::string::npos; at = sql.find(what, at + with.size()))
    sql.replace(at, what.size(), with);
}

/// Replaces what stands between two @.
std::string filled(std::string sql) {
  for (const mpm::ResultRow& row : mpm::results())
    if (!row.error_column.empty())
      replace_all(sql, "@error of " + std::string(row.name) + "@", error_of(row));
  replace_all(sql, "@widest@", widest_interval);
  replace_all(sql, "@room@", room_of_collapsed);
  replace_all(sql, "@stale@", stale_sql());
  return sql;
}

/// The view `ladders`: one SELECT for every place that a value stands in, so that a study's own rows are
/// found without looking at all others.
std::string ladders_sql() {
  const auto select = [](const std::string& quantity, const std::string& value, const std::string& unit,
                         const std::string& error, const std::string& rest) {
    return "SELECT s.name AS study, a.key AS key, m.position AS position, r.key AS rung_key, "
           "r.cell_size_m AS cell_size_m, r.status AS status, " +
           quantity + " AS quantity, " + value + " AS value, " + unit + " AS unit, " + error +
           " AS measuring_error FROM study s JOIN study_job m ON m.study_id = s.id AND m.coarse = 0 "
           "JOIN job a ON a.id = m.job_id "
           "JOIN study_job n ON n.study_id = m.study_id AND n.position = m.position "
           "JOIN job r ON r.id = n.job_id " +
           rest;
  };
  std::string sql = "DROP VIEW IF EXISTS ladders;\nCREATE VIEW ladders AS " +
                    select("c.name", "c.value", "c.unit", "c.error", "JOIN metric c ON c.job_id = r.id");
  for (const mpm::ResultRow& row : mpm::results()) {
    if (row.error_column.empty()) continue;
    const std::string column = "r." + std::string(row.name);
    sql +=
        "\nUNION ALL " + select("'" + std::string(row.name) + "'", column, "'" + std::string(row.unit) + "'",
                                "r." + std::string(row.error_column), "WHERE " + column + " IS NOT NULL");
  }
  return sql + "\nUNION ALL " + select("NULL", "NULL", "NULL", "NULL", "WHERE r.status <> 'done'") + ";\n";
}

}  // namespace

std::string stale_sql() {
  return "physics_version < max((SELECT version FROM physics), CASE \"kernel\" WHEN 'reference' THEN " +
         std::to_string(mpm::reference_physics_version) + " ELSE 0 END)";
}

std::string view_sql(std::span<const std::string> columns) {
  std::string sql(jobs_before);
  for (const auto& column : columns) sql += "  j.\"" + column + "\" AS \"" + column + "\",\n";
  sql += jobs_after;
  sql += other_views;
  return filled(sql + ladders_sql());
}

}  // namespace mpmstudy
