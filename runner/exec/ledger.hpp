#pragma once
/// Where the executor reserves jobs and hands over their results. The catalog is one; tests
/// have a simpler one. Any thread may call it.
#include <string>

#include "runner/catalog/records.hpp"

namespace mpmstudy {

class Ledger {
 public:
  virtual ~Ledger() = default;
  /// Reserves a job for this process; on record before this returns. A job whose process is gone is taken up.
  virtual JobReservation reserve(const std::string& key) = 0;
  /// The job's own process, which this one had started, died; the job stays this one's. Gives back how often
  /// that has happened to it.
  virtual std::int64_t crashed(const std::string& key) = 0;
  /// The job is decided. Its files must be on disk. On record before this returns true. False, and nothing is
  /// on record, if another process has taken the job up meanwhile: then that one's result counts.
  virtual bool complete(FinishedJob) = 0;
  /// The job is stopped and planned again.
  virtual void release(const std::string& key, const std::string& reason) = 0;
  /// Is it known that another process has taken up a job of this one? Asked after every step.
  virtual bool lost(const std::string& /*key*/) const { return false; }
  /// Is the job still this process's to run? Asks the record.
  virtual bool holds(const std::string& /*key*/) { return true; }
  /// Returns when everything handed over is on record. Throws what went wrong on the way.
  virtual void flush() = 0;
};

}  // namespace mpmstudy
