#pragma once
/// Who watches a run. Every member may be called from any worker, several at once; an implementation locks.
/// None of them throws.
#include <cstdint>
#include <string>

#include "libmpm/simulation.hpp"
#include "runner/catalog/records.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {

struct RunStart {
  std::int64_t jobs = 0;         ///< to run now
  std::int64_t reused = 0;       ///< done before
  std::int64_t left_failed = 0;  ///< failed before, left so
  std::int64_t taken_up = 0;     ///< of jobs: left behind by a process that is gone
  double predicted_seconds = 0;  ///< sum over the jobs to run, on one core
  unsigned workers = 1;
  std::int64_t damaged = 0;     ///< of jobs: were done, but files of theirs are missing or damaged
  double predicted_factor = 1;  ///< in 95 % of runs it is no more, and no less, than so many times that
  std::string study = {};       ///< its name, if there is one only
};

/// How one job ended: done, failed, or planned (again) if it was stopped.
struct JobEnd {
  JobStatus status = JobStatus::done;
  std::string reason;  ///< why it failed, or was stopped; "" if the run was asked to stop
  std::int64_t particles = 0;
  std::int64_t steps = 0;
  double wall_s = 0;  ///< [s]
  double cpu_s = 0;   ///< [s]

  double updates() const { return static_cast<double>(particles) * static_cast<double>(steps); }
  double updates_per_second() const { return cpu_s > 0 ? updates() / cpu_s : 0; }
};

struct RunEnd {
  std::int64_t done = 0, failed = 0, reused = 0, left = 0;
  double wall_s = 0;              ///< [s]
  double updates_per_second = 0;  ///< particle updates per second and core
  std::string stop_reason;        ///< "" if all was decided
  double predicted_s = 0;         ///< of the jobs that are done now, on one core [s]
  double predicted_factor = 1;    ///< as of RunStart
  double cpu_s = 0;               ///< that they took [s]
};

class Status {
 public:
  virtual ~Status() = default;
  virtual void run_started(const RunStart&) {}
  /// Results have asked for more jobs: counted and predicted as run_started's.
  virtual void jobs_added(std::int64_t /*jobs*/, double /*predicted_seconds*/) {}
  virtual void job_started(const Job&) {}
  virtual void job_progress(const Job&, const mpm::Progress&) {}
  /// Something that a user has to know about a job that runs: "begins anew: ...".
  virtual void job_noted(const Job&, const std::string& /*text*/) {}
  virtual void job_finished(const Job&, const JobEnd&) {}
  virtual void run_finished(const RunEnd&) {}
};

}  // namespace mpmstudy
