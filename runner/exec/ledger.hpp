#pragma once
/// Where the executor asks for leave to run a job and hands over what it left. The catalog is one; tests
/// have a simpler one. Any thread may call it.
#include <string>

#include "runner/catalog/records.hpp"

namespace mpmstudy {

class Ledger {
 public:
  virtual ~Ledger() = default;
  /// True if the job is now this process's to run; on record before this returns.
  virtual bool claim(const std::string& key) = 0;
  /// The job is decided. Its files must be on disk. Taken by value: the worker goes on at once.
  virtual void finish(FinishedJob) = 0;
  /// The job is stopped and planned again.
  virtual void release(const std::string& key, const std::string& reason) = 0;
  /// Returns when everything handed over is on record. Throws what went wrong on the way.
  virtual void flush() = 0;
};

}  // namespace mpmstudy
