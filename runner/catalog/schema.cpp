#include "runner/catalog/schema.hpp"

#include "libmpm/scene/parameters.hpp"

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
CREATE TABLE claim (             -- statements of a publication, judged
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

// Numbers stand without the last digits of what they were computed from, so that they are found as they would
// be written; where keys are made of those digits, they are kept beside. Older rows get both, and flags of
// brackets get units, by catch_up.hpp. Through as many points as coefficients every curve goes.
constexpr std::string_view version_8 = R"sql(
ALTER TABLE job ADD COLUMN exact TEXT;            -- JSON object: column -> value with all digits; null: as it stands
ALTER TABLE bracket ADD COLUMN exact_lower REAL;  -- with all digits
ALTER TABLE bracket ADD COLUMN exact_upper REAL;
UPDATE fit SET r2 = NULL WHERE points <= (SELECT count(*) FROM fit f WHERE f.study_id = fit.study_id AND
  f.quantity = fit.quantity AND f.against = fit.against AND f.model = fit.model AND f.family = fit.family);
)sql";

// Why a study asked for a job, as it was known when it did.
constexpr std::string_view version_9 = R"sql(
ALTER TABLE study_job ADD COLUMN reason TEXT;  -- null: entered by an older program
)sql";

// What the gauges of a scene have seen.
constexpr std::string_view version_10 = R"sql(
ALTER TABLE job ADD COLUMN gauges TEXT;  -- JSON array; null: it has none
CREATE TABLE gauge (              -- of the scene of a job
  job_id INTEGER NOT NULL REFERENCES job (id),
  gauge  INTEGER NOT NULL,         -- its number, in the order of the scene
  name   TEXT NOT NULL,
  unit   TEXT NOT NULL,
  PRIMARY KEY (job_id, gauge)
) STRICT, WITHOUT ROWID;
CREATE TABLE history_sample (
  job_id INTEGER NOT NULL REFERENCES job (id),
  gauge  INTEGER NOT NULL,
  sample INTEGER NOT NULL,
  time_s REAL NOT NULL,
  value  REAL NOT NULL,
  PRIMARY KEY (job_id, gauge, sample)
) STRICT, WITHOUT ROWID;
)sql";

// Scenes that are composed of bodies, and what studies call parameters of their own.
constexpr std::string_view version_11 = R"sql(
ALTER TABLE job ADD COLUMN composition TEXT;  -- JSON object; null: its kind has none
CREATE TABLE own_parameter (
  study_id INTEGER NOT NULL REFERENCES study (id),
  job_id   INTEGER NOT NULL REFERENCES job (id),
  name     TEXT NOT NULL,
  value    REAL NOT NULL,
  unit     TEXT NOT NULL,
  PRIMARY KEY (study_id, job_id, name)
) STRICT, WITHOUT ROWID;
)sql";

std::vector<ParameterColumn> parameter_columns() {
  std::vector<ParameterColumn> columns;
  for (const auto& quantity : mpm::quantities()) columns.push_back({std::string(quantity.column), "REAL"});
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
           {7, version_7},
           {8, version_8},
           {9, version_9},
           {10, version_10},
           {11, version_11}},
          parameter_columns()};
}

}  // namespace mpmstudy
