#include "runner/catalog/schema.hpp"

#include <algorithm>

#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/physics_version.hpp"

namespace mpmstudy {
namespace {

// Child tables hang on job.id, not on the key: an area history is a few hundred rows, a key 32 characters.
constexpr std::string_view version_1 = R"sql(
CREATE TABLE runner (           -- a process that has written here
  id            INTEGER PRIMARY KEY,
  host          TEXT NOT NULL,
  boot_id       TEXT NOT NULL,
  pid           INTEGER NOT NULL,
  process_start INTEGER NOT NULL,  -- clock ticks after boot
  git_revision  TEXT NOT NULL,
  started_at    TEXT NOT NULL,
  heartbeat_at  TEXT NOT NULL,
  ended_at      TEXT               -- null: alive, or killed
) STRICT;

CREATE TABLE study (
  id         INTEGER PRIMARY KEY,
  name       TEXT NOT NULL UNIQUE,
  title      TEXT NOT NULL,
  updated_at TEXT NOT NULL
) STRICT;

CREATE TABLE job (
  id                   INTEGER PRIMARY KEY,
  key                  TEXT NOT NULL UNIQUE,
  scene                TEXT NOT NULL,
  material             TEXT NOT NULL,
  snapshot_times       TEXT NOT NULL,  -- JSON array [s]
  physics_version      INTEGER NOT NULL,
  predicted_particles  INTEGER NOT NULL,
  predicted_steps      INTEGER NOT NULL,
  predicted_s          REAL,
  status               TEXT NOT NULL CHECK (status IN ('planned','running','done','failed','cancelled')),
  reason               TEXT,
  attempt              INTEGER NOT NULL DEFAULT 0,
  runner_id            INTEGER REFERENCES runner (id),
  started_at           TEXT,
  finished_at          TEXT,
  particles            INTEGER,
  steps                INTEGER,
  wall_s               REAL,
  cpu_s                REAL,
  energy_error         REAL,
  outcome              TEXT,
  initial_area_m2      REAL,
  final_area_m2        REAL,
  final_area_error_m2  REAL,
  collapsibility       REAL,
  collapsibility_error REAL,
  git_revision         TEXT,
  host                 TEXT
) STRICT;
CREATE INDEX job_open ON job (status) WHERE status IN ('planned', 'running');

-- One column for every parameter that a scene can have; they are added by opening.
CREATE TABLE job_parameters (job_id INTEGER PRIMARY KEY REFERENCES job (id)) STRICT;

CREATE TABLE study_job (
  study_id INTEGER NOT NULL REFERENCES study (id),
  job_id   INTEGER NOT NULL REFERENCES job (id),
  position INTEGER NOT NULL,       -- in the sweep
  PRIMARY KEY (study_id, job_id)
) STRICT, WITHOUT ROWID;
CREATE INDEX study_job_by_job ON study_job (job_id);

CREATE TABLE metric (
  job_id INTEGER NOT NULL REFERENCES job (id),
  name   TEXT NOT NULL,
  value  REAL,                     -- null: not a number
  unit   TEXT NOT NULL,
  error  REAL,
  PRIMARY KEY (job_id, name)
) STRICT, WITHOUT ROWID;

CREATE TABLE area_sample (
  job_id       INTEGER NOT NULL REFERENCES job (id),
  sample       INTEGER NOT NULL,
  time_s       REAL,
  area_m2      REAL,
  void_area_m2 REAL,
  PRIMARY KEY (job_id, sample)
) STRICT, WITHOUT ROWID;

CREATE TABLE snapshot (
  job_id   INTEGER NOT NULL REFERENCES job (id),
  time_s   REAL,
  step     INTEGER NOT NULL,
  path     TEXT NOT NULL,
  bytes    INTEGER NOT NULL,
  checksum TEXT NOT NULL,
  PRIMARY KEY (job_id, path)
) STRICT, WITHOUT ROWID;

CREATE TABLE event (               -- every transition of every job, once
  id          INTEGER PRIMARY KEY,
  job_id      INTEGER NOT NULL REFERENCES job (id),
  from_status TEXT,                -- null: the job is new
  to_status   TEXT NOT NULL,
  at          TEXT NOT NULL,
  runner_id   INTEGER NOT NULL REFERENCES runner (id),
  attempt     INTEGER NOT NULL,
  reason      TEXT
) STRICT;
CREATE INDEX event_by_job ON event (job_id);

CREATE TABLE fit (
  study_id       INTEGER NOT NULL REFERENCES study (id),
  position       INTEGER NOT NULL,
  quantity       TEXT NOT NULL,
  against        TEXT NOT NULL,
  model          TEXT NOT NULL,
  coefficient    TEXT NOT NULL,
  value          REAL,
  standard_error REAL,
  r2             REAL,
  unit           TEXT NOT NULL,
  PRIMARY KEY (study_id, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE critical_speed_bracket (
  study_id         INTEGER NOT NULL REFERENCES study (id),
  position         INTEGER NOT NULL,
  wall_thickness_m REAL,
  lower_m_s        REAL NOT NULL,
  upper_m_s        REAL NOT NULL,
  lower_key        TEXT NOT NULL,
  upper_key        TEXT NOT NULL,
  cell_size_m      REAL NOT NULL,
  PRIMARY KEY (study_id, position)
) STRICT, WITHOUT ROWID;
)sql";

constexpr std::string_view version_2 = R"sql(
ALTER TABLE study_job ADD COLUMN coarse INTEGER NOT NULL DEFAULT 0;  -- 1: a coarser cell of the job at its position
CREATE INDEX study_job_by_position ON study_job (study_id, position);

CREATE TABLE interval (            -- of one number of one job, from the cells under it
  study_id             INTEGER NOT NULL REFERENCES study (id),
  job_id               INTEGER NOT NULL REFERENCES job (id),
  quantity             TEXT NOT NULL,
  unit                 TEXT NOT NULL,
  value                REAL NOT NULL,
  error                REAL NOT NULL,
  extrapolated_value   REAL NOT NULL,
  extrapolated_error   REAL NOT NULL,
  observed_order       REAL,
  method               TEXT NOT NULL,
  cells                INTEGER NOT NULL,
  discretisation_error REAL NOT NULL,
  measuring_error      REAL NOT NULL,
  measuring_difference REAL,        -- the parts of measuring_error, where they are known
  scatter              REAL,
  wanted_error         REAL,        -- of an accuracy
  PRIMARY KEY (study_id, job_id, quantity)
) STRICT, WITHOUT ROWID;
CREATE INDEX interval_by_job ON interval (job_id, quantity);
)sql";

constexpr std::string_view version_3 = R"sql(
ALTER TABLE critical_speed_bracket ADD COLUMN extrapolated_m_s REAL;  -- to cells of size 0, on the finest row
ALTER TABLE critical_speed_bracket ADD COLUMN interval_m_s REAL;      -- half width, resolution included
ALTER TABLE critical_speed_bracket ADD COLUMN flags TEXT NOT NULL DEFAULT '';
ALTER TABLE critical_speed_bracket ADD COLUMN runs INTEGER;           -- jobs that the search asked for
CREATE TABLE claim (             -- sentences of the paper, judged
  position INTEGER PRIMARY KEY,
  name     TEXT NOT NULL,
  sentence TEXT NOT NULL,
  study    TEXT NOT NULL,
  measured TEXT NOT NULL,
  verdict  TEXT NOT NULL,
  note     TEXT NOT NULL
) STRICT;
ALTER TABLE fit ADD COLUMN covariance TEXT;                           -- with c0, c1, ...: JSON array
)sql";

constexpr std::string_view version_4 = R"sql(
ALTER TABLE job ADD COLUMN failure_kind TEXT
  CHECK (failure_kind IN ('breakdown','timeout','memory','crash','error'));
ALTER TABLE job ADD COLUMN crashes INTEGER NOT NULL DEFAULT 0;  -- times that its process ended while it ran
ALTER TABLE study ADD COLUMN path TEXT;       -- of the file, when it was last registered
ALTER TABLE study ADD COLUMN overrides TEXT;  -- JSON array of its --set
CREATE TABLE physics (version INTEGER NOT NULL) STRICT;  -- one row: the newest that has written here
INSERT INTO physics (version) VALUES (0);
)sql";

// Answers over all jobs of a large study: a state is counted, and a job's studies are found, without their
// rows.
constexpr std::string_view version_5 = R"sql(
DROP INDEX job_open;
CREATE INDEX job_by_status ON job (status);
DROP INDEX study_job_by_job;
CREATE INDEX study_job_by_job ON study_job (job_id, coarse);
)sql";

// A job's parameters stand in its own row (opening moves them there from job_parameters): every answer over
// all jobs of a large study looked them up one by one.
constexpr std::string_view version_6 = R"sql(
CREATE TABLE parameter_column (name TEXT PRIMARY KEY) STRICT;  -- which columns of job are parameters, in their order
DROP INDEX interval_by_job;
CREATE INDEX interval_by_job ON interval (job_id, quantity, cells DESC, study_id, error);
ALTER TABLE study ADD COLUMN cells REAL NOT NULL DEFAULT 1;    -- its --cells
)sql";

// Brackets of any quantity. The table before held speeds, and other quantities as if they were speeds: what
// its rows are of is looked up in their jobs (catch_up.hpp).
constexpr std::string_view version_7 = R"sql(
DROP VIEW IF EXISTS critical_speed;
CREATE TABLE bracket (
  study_id         INTEGER NOT NULL REFERENCES study (id),
  position         INTEGER NOT NULL,   -- of the point in the study's sweep
  quantity         TEXT NOT NULL,      -- what was searched: 'impact_speed'
  unit             TEXT NOT NULL,      -- of lower, upper, extrapolated, interval
  lower            REAL,               -- null: not found, flags say why
  upper            REAL,
  lower_key        TEXT,
  upper_key        TEXT,
  cell_size_m      REAL NOT NULL,
  extrapolated     REAL,               -- to cells of size 0, on the finest row
  interval         REAL,               -- half width, resolution included
  flags            TEXT NOT NULL DEFAULT '',
  runs             INTEGER,            -- jobs that the search asked for
  swept            TEXT NOT NULL,      -- JSON object: column of jobs -> value of what else the study sweeps
  wall_thickness_m REAL,               -- for the view critical_speed
  PRIMARY KEY (study_id, position)
) STRICT, WITHOUT ROWID;
INSERT INTO bracket SELECT study_id, position, 'impact_speed', 'm/s', lower_m_s, upper_m_s, lower_key, upper_key,
  cell_size_m, extrapolated_m_s, interval_m_s, flags, runs,
  CASE WHEN wall_thickness_m IS NULL THEN '{}' ELSE json_object('wall_thickness_m', wall_thickness_m) END,
  wall_thickness_m
FROM critical_speed_bracket;
DROP TABLE critical_speed_bracket;
ALTER TABLE fit ADD COLUMN reduced_chi2 REAL;  -- weighted squares of the residuals per degree of freedom; null: no weights
ALTER TABLE fit ADD COLUMN points INTEGER;     -- through how many it goes
ALTER TABLE fit ADD COLUMN family TEXT NOT NULL DEFAULT '{}';  -- JSON object: column of jobs -> value of what else is swept
ALTER TABLE job ADD COLUMN former_key TEXT;  -- while a parameter without an effect was part of its key
CREATE INDEX job_by_former_key ON job (former_key) WHERE former_key IS NOT NULL;
ALTER TABLE snapshot ADD COLUMN modified_ns INTEGER;                  -- of the file, by its file system's clock
ALTER TABLE runner ADD COLUMN name_space TEXT NOT NULL DEFAULT '';   -- in which pid and process_start mean something
ALTER TABLE runner ADD COLUMN beats INTEGER NOT NULL DEFAULT 0;      -- signs of life: clocks may stand still or step
ALTER TABLE runner ADD COLUMN expires_s REAL NOT NULL DEFAULT 60;    -- after this silence its jobs may be taken
)sql";

constexpr std::string_view jobs_before = R"sql(
DROP VIEW IF EXISTS jobs;
CREATE VIEW jobs AS SELECT
  j.key AS key, s.name AS study, j.status AS status, j.reason AS reason,
)sql";

constexpr std::string_view jobs_after = R"sql(
  j.particles AS particles, j.steps AS steps, j.wall_s AS wall_s, j.cpu_s AS cpu_s,
  j.energy_error AS energy_error, j.outcome AS outcome, j.initial_area_m2 AS initial_area_m2,
  j.final_area_m2 AS final_area_m2,
  coalesce((SELECT i.error FROM interval i
            WHERE i.job_id = j.id AND i.quantity = 'final_area_m2' AND i.study_id = m.study_id),
           (SELECT i.error FROM interval i WHERE i.job_id = j.id AND i.quantity = 'final_area_m2'
            ORDER BY i.cells DESC, i.study_id LIMIT 1),
           j.final_area_error_m2) AS final_area_error_m2,
  j.collapsibility AS collapsibility,
  coalesce((SELECT i.error FROM interval i
            WHERE i.job_id = j.id AND i.quantity = 'collapsibility' AND i.study_id = m.study_id),
           (SELECT i.error FROM interval i WHERE i.job_id = j.id AND i.quantity = 'collapsibility'
            ORDER BY i.cells DESC, i.study_id LIMIT 1),
           j.collapsibility_error) AS collapsibility_error,
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

DROP VIEW IF EXISTS snapshots;
CREATE VIEW snapshots AS SELECT j.key AS key, c.time_s AS time_s, c.path AS path, c.bytes AS bytes,
  c.checksum AS checksum, c.step AS step
FROM job j JOIN snapshot c ON c.job_id = j.id;

DROP VIEW IF EXISTS events;
CREATE VIEW events AS SELECT j.key AS key, e.from_status AS from_status, e.to_status AS to_status, e.at AS at,
  r.host || ':' || r.pid AS "by", e.attempt AS attempt, e.reason AS reason, e.id AS id
FROM event e JOIN job j ON j.id = e.job_id JOIN runner r ON r.id = e.runner_id;

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
CREATE VIEW brackets AS SELECT s.name AS study, b.quantity AS quantity, b.unit AS unit, b.lower AS lower,
  b.upper AS upper, b.lower_key AS lower_key, b.upper_key AS upper_key, b.cell_size_m AS cell_size_m,
  b.extrapolated AS extrapolated, b.interval AS interval, b.flags AS flags, b.runs AS runs,
  b.position AS position, b.swept AS swept
FROM study s JOIN bracket b ON b.study_id = s.id;

DROP VIEW IF EXISTS critical_speed;
CREATE VIEW critical_speed AS SELECT s.name AS study, b.wall_thickness_m AS wall_thickness_m,
  b.lower AS lower_m_s, b.upper AS upper_m_s, b.lower_key AS lower_key, b.upper_key AS upper_key,
  b.cell_size_m AS cell_size_m, b.extrapolated AS extrapolated_m_s, b.interval AS interval_m_s,
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
  return "DROP VIEW IF EXISTS ladders;\nCREATE VIEW ladders AS " +
         select("c.name", "c.value", "c.unit", "c.error", "JOIN metric c ON c.job_id = r.id") +
         "\nUNION ALL " +
         select("'collapsibility'", "r.collapsibility", "'1'", "r.collapsibility_error",
                "WHERE r.collapsibility IS NOT NULL") +
         "\nUNION ALL " +
         select("'final_area_m2'", "r.final_area_m2", "'m2'", "r.final_area_error_m2",
                "WHERE r.final_area_m2 IS NOT NULL") +
         "\nUNION ALL " + select("NULL", "NULL", "NULL", "NULL", "WHERE r.status <> 'done'") + ";\n";
}

std::vector<ParameterColumn> parameter_columns() {
  std::vector<ParameterColumn> columns;
  for (const auto& quantity : mpm::quantities()) columns.push_back({std::string(quantity.column), "REAL"});
  // Promised to queries before the scenes that have them exist.
  for (const char* name : {"inner_radius_m", "outer_radius_m", "inner_speed_m_s"})
    if (std::ranges::none_of(columns, [&](const auto& column) { return column.name == name; }))
      columns.push_back({name, "REAL"});
  for (const auto& choice : mpm::choices()) columns.push_back({std::string(choice.column), "TEXT"});
  return columns;
}

}  // namespace

CatalogSchema current_catalog_schema() {
  return {{{1, version_1},
           {2, version_2},
           {3, version_3},
           {4, version_4},
           {5, version_5},
           {6, version_6},
           {7, version_7}},
          parameter_columns()};
}

std::string stale_sql() {
  return "physics_version < max((SELECT version FROM physics), CASE \"kernel\" WHEN 'reference' THEN " +
         std::to_string(mpm::reference_physics_version) + " ELSE 0 END)";
}

std::string view_sql(std::span<const std::string> columns) {
  std::string sql(jobs_before);
  for (const auto& column : columns) sql += "  j.\"" + column + "\" AS \"" + column + "\",\n";
  std::string after(jobs_after);
  constexpr std::string_view stale = "@stale@";
  sql += after.replace(after.find(stale), stale.size(), stale_sql());
  sql += other_views;
  return sql += ladders_sql();
}

}  // namespace mpmstudy
