#pragma once
/// Where the executor asks for leave to run a job and hands over what it left. The catalog is one; tests
/// have a simpler one. Any thread may call it.
#include <string>

#include "runner/catalog/records.hpp"

namespace mpmstudy {

class Ledger {
 public:
  virtual ~Ledger() = default;
  /// Asks to run a job; on record before this returns. A job whose process is gone is taken up.
  virtual JobClaim claim(const std::string& key) = 0;
  /// The job's own process, which this one had started, died; the job stays this one's. Gives back how often
  /// that has happened to it.
  virtual std::int64_t crashed(const std::string& key) = 0;
  /// The job is decided. Its files must be on disk. Taken by value: the worker goes on at once. The result of
  /// a job that another process has taken up meanwhile is dropped.
  virtual void finish(FinishedJob) = 0;
  /// The job is stopped and planned again.
  virtual void release(const std::string& key, const std::string& reason) = 0;
  /// Returns when everything handed over is on record. Throws what went wrong on the way.
  virtual void flush() = 0;
};

}  // namespace mpmstudy
