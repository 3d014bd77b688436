#pragma once
/// What the catalog is told and what it answers: plain values in SI units, which any thread may own.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "libmpm/simulation.hpp"

namespace mpmstudy {

/// planned -> running -> done | failed; running -> planned when a run is stopped or its process is gone;
/// planned -> cancelled when no study wants the job any longer.
enum class JobStatus { planned, running, done, failed, cancelled };
std::string_view to_string(JobStatus);
/// Throws CatalogError for a word that is no status.
JobStatus job_status_from(std::string_view);

/// Why a job failed.
enum class FailureKind {
  breakdown,  ///< the numbers left the range in which they mean something: a result of the simulation
  timeout,    ///< it ran over --timeout
  memory,     ///< it ran over --memory, or there was no more
  crash,      ///< its process died, as often as is allowed
  error       ///< anything else that it threw
};
std::string_view to_string(FailureKind);
/// Throws CatalogError for a word that is no kind of failure.
FailureKind failure_kind_from(std::string_view);

/// A field file that is on disk, whole and synced.
struct SnapshotFile {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::string path;  ///< relative to the results folder
  std::int64_t bytes = 0;
  std::string checksum;  ///< XXH3-128 of the file, 32 hexadecimal digits
  /// When it was written, by the clock of its file system [ns since 1970]; 0: not known.
  std::int64_t modified_ns = 0;
};

/// A job that has been decided, with everything that it left.
struct FinishedJob {
  std::string key;
  JobStatus status = JobStatus::done;  ///< done or failed
  std::string reason;                  ///< of a failure
  std::optional<FailureKind> failure;  ///< of a failed job
  mpm::RunResult result;
  std::vector<SnapshotFile> snapshots;
  double wall_s = 0;  ///< duration [s]
  double cpu_s = 0;   ///< time on a processor [s]
};

/// One coefficient of one fit; a row of the view `fits`.
struct FitRow {
  std::string quantity;     ///< what is fitted: "collapsibility"
  std::string against;      ///< over what: "cavity_radius"
  std::string model;        ///< "quadratic"
  std::string coefficient;  ///< "c0", "c1", ...
  double value = 0;
  std::optional<double> standard_error;
  std::optional<double> r2;
  std::string unit;  ///< of value
  /// With c0, c1, ... [unit of the product]; empty where standard errors are unknown.
  std::vector<double> covariance{};
  /// Weighted sum of squares of the residuals per degree of freedom: above 1 the points scatter more than
  /// their intervals say. Empty: all weigh the same, or none to spare.
  std::optional<double> reduced_chi2{};
  std::int64_t points = 0;    ///< that the fit goes through
  std::string family = "{}";  ///< JSON object: column of jobs -> value of what else the study sweeps
  std::string r2_text{};      ///< for people: "0.9987", or why it is not judged
};

/// The interval of one number of one job; a row of the view `accuracy`. Half widths, in `unit`.
struct IntervalRow {
  std::string key;       ///< of the job with the finest cell
  std::string quantity;  ///< "collapsibility"
  std::string unit;      ///< SI; "1" for a pure number
  double value = 0;      ///< of that job
  double error = 0;      ///< of the whole interval about it
  double extrapolated_value = 0;
  double extrapolated_error = 0;  ///< of the interval about that
  std::optional<double> observed_order;
  std::string method;  ///< analysis/extrapolation.hpp
  int cells = 1;       ///< that the interval was made from
  double discretisation_error = 0;
  double measuring_error = 0;
  std::optional<double> measuring_difference, scatter;  ///< the parts of measuring_error, where known
  std::optional<double> wanted_error;                   ///< of an accuracy
};

/// A bracket of a critical value and the two jobs that prove it; a row of the view `brackets`.
struct BracketRow {
  std::string quantity;                    ///< what was searched: "impact_speed"
  std::string unit;                        ///< SI; of lower, upper, extrapolated, interval
  std::optional<double> lower, upper;      ///< empty: not found, and flags say why
  std::string lower_key, upper_key;        ///< "" without ends
  double cell_size = 0;                    ///< [m]
  std::optional<double> extrapolated{};    ///< to cells of size 0; on the finest cell of a ladder
  std::optional<double> interval{};        ///< half width of its interval, resolution included
  std::string flags{};                     ///< what a reader has to know: "flips back at 410"; mostly ""
  std::int64_t runs = 0;                   ///< jobs that this search asked for
  std::int64_t position = 0;               ///< of the point in the study's sweep
  std::string swept = "{}";                ///< JSON object: column of jobs -> value of what else is swept
  std::optional<double> wall_thickness{};  ///< [m]; for the view `critical_speed`
};

/// One statement of a publication, judged; a row of the view `claims`.
struct Claim {
  std::string name;      ///< short, for queries: "grows-with-speed"
  std::string sentence;  ///< what it says
  std::string study;     ///< whose jobs the number is from
  std::string measured;  ///< the number, with its error where one is known
  std::string verdict;   ///< "holds", "does not", "not comparable", or "not run"
  std::string note;      ///< what the verdict rests on
};

/// The answer to a request to run a job.
struct JobReservation {
  bool mine = false;                        ///< it is this process's to run
  JobStatus status = JobStatus::cancelled;  ///< what it is, if it is not: running (by another), done, failed
  std::int64_t crashes = 0;                 ///< how often its process has ended while it ran
  explicit operator bool() const { return mine; }
};

/// Where a study comes from; for those who ask later.
struct StudySource {
  std::string path;              ///< of its file
  std::vector<std::string> set;  ///< its --set
  double cells = 1;              ///< its --cells
};

/// What registering does to the jobs that a study had.
enum class Members {
  exactly,   ///< those that are not given leave it
  at_least,  ///< as exactly, unless it has all that are given: then it keeps its other ones, too
  also       ///< those that are given are added
};

/// Some of the jobs that are registered: only they are to run.
struct Selection {
  Members members = Members::exactly;
  std::optional<std::unordered_set<std::string>> keys{};   ///< none: all
  std::optional<std::unordered_set<std::string>> retry{};  ///< where failed jobs are to run again; none: all
  bool has(const std::string& key) const { return !keys || keys->contains(key); }
  bool retries(const std::string& key) const { return has(key) && (!retry || retry->contains(key)); }
};

/// Which failed jobs; "": any.
struct RetryFilter {
  std::string key_begins, study, kind;
};

/// What became of the jobs of another catalog.
struct MergeReport {
  std::int64_t merged = 0;             ///< taken over
  std::int64_t same = 0;               ///< known here already
  std::vector<std::string> conflicts;  ///< two results under one key; this catalog keeps its own
  std::vector<std::string> damaged;    ///< files that are not as they were written; their jobs are left out
};

/// What registering a study found.
struct Registration {
  std::vector<JobStatus> states;       ///< of every job, in the order of the plan; planned: to run
  std::vector<std::string> to_run;     ///< keys of these
  std::int64_t done = 0;               ///< decided before: not run again
  std::int64_t failed = 0;             ///< failed before and left so
  std::int64_t running_elsewhere = 0;  ///< by another process that is alive
  std::int64_t taken_up = 0;           ///< of to_run: left behind by a process that is gone
  std::int64_t damaged = 0;            ///< of to_run: were done, but a file of theirs is missing or damaged
};

}  // namespace mpmstudy
