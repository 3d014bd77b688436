#pragma once
/// What runs next. A planner is asked again and again: it is given what is known and says which jobs it
/// wants. Pure: no clock, no disk, no catalog. What it asks for depends on results only, not on who ran them,
/// how many at a time, or in which order, so that a run that was stopped asks for the same jobs again.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runner/plan/plan.hpp"

namespace mpmstudy {

/// How a job has ended.
struct Answer {
  bool done = false;    ///< false: it has failed
  std::string outcome;  ///< "" if it has failed
  double margin = 0;    ///< distance from the other outcome; 0 if the run does not say
};

/// A result of a done job, in SI units.
struct Reading {
  double value = 0, error = 0;  ///< error: of the measurement on these cells alone, not negative
};

/// What is known.
class Answers {
 public:
  virtual ~Answers() = default;
  /// Empty: the job is not decided.
  virtual std::optional<Answer> of(const std::string& key) const = 0;
  /// Empty: it is not done, or does not show the quantity.
  virtual std::optional<Reading> reading(const std::string& key, const std::string& quantity) const = 0;
  /// Why the area of the job's cavity means nothing (view `jobs`); "": it does.
  virtual std::string flags(const std::string& /*key*/) const { return {}; }
};

class Planner {
 public:
  virtual ~Planner() = default;
  /// Jobs that are wanted now and were not before, each with its reason. Empty: none will be, or a job that
  /// was asked for is not decided.
  virtual std::vector<Job> next(const Answers&) = 0;
};

/// The jobs of a plan, all at once.
class Sweep : public Planner {
 public:
  explicit Sweep(std::vector<Job> jobs) : jobs_(std::move(jobs)) {}
  std::vector<Job> next(const Answers&) override { return std::exchange(jobs_, {}); }

 private:
  std::vector<Job> jobs_;
};

}  // namespace mpmstudy
