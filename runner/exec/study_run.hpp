#pragma once
/// One study of a run: what its planner asks for, entered in the catalog.
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "runner/catalog/writer.hpp"
#include "runner/plan/planner.hpp"
#include "runner/search/search_planner.hpp"

namespace mpmstudy {

/// A study as it is given to a run.
struct PlannedStudy {
  Plan plan;  ///< of a search: its name and its costs alone
  std::string title;
  StudySource source = {};
  /// Of a run that is to run some jobs only; all others stay what they are. Keys may be those of finer cells,
  /// or of jobs that a search may ask for, as well.
  Selection selection = {};
  std::optional<Study> search = {};  ///< the study itself, where it has a [search] that is to run
  /// Share of the runs of the search that ended early which are run to their end, 0 ... 1; they belong to the
  /// study NAME-audit.
  double audit = 0;
  std::optional<Study> surface = {};  ///< the study itself, where it has a [surface]
};

/// The jobs that a run of the study begins with: those of the plan that the selection has, each key once.
std::vector<Job> jobs_to_run(const PlannedStudy&);

/// What a run of the study would run now, by what is known; of a search, its next round.
std::vector<Job> jobs_wanted(const PlannedStudy&, const Answers&);

/// Failed jobs count as not decided until this run has tried them, where it is to try them again.
class RunAnswers : public Answers {
 public:
  RunAnswers(const Answers& known, bool retry_failed) : known_(known), retry_failed_(retry_failed) {}
  std::optional<Answer> of(const std::string& key) const override;
  std::optional<Reading> reading(const std::string& key, const std::string& quantity) const override {
    return known_.reading(key, quantity);
  }
  std::string flags(const std::string& key) const override { return known_.flags(key); }
  void tried(const std::string& key) { tried_.insert(key); }
  /// Whether the job is to run again if it has failed.
  bool retries(const std::string& key) const { return retry_failed_ && !tried_.contains(key); }

 private:
  const Answers& known_;
  bool retry_failed_;
  std::set<std::string> tried_;
};

/// What was asked for, and what the catalog has of it.
struct Entered {
  std::vector<Job> jobs;
  std::vector<JobStatus> states;  ///< of each
  std::int64_t taken_up = 0, damaged = 0;
};

class StudyRun {
 public:
  /// The study must outlive this.
  explicit StudyRun(const PlannedStudy&);

  /// Has the planner asked until it waits for results, or has no more to ask for, and makes the catalog's
  /// study have all that it wants. Throws CatalogError.
  Entered advance(const RunAnswers&, CatalogWriter&);

  const PlannedStudy& study() const { return study_; }
  const SearchPlanner* search() const { return search_; }  ///< null: it is none

 private:
  const PlannedStudy& study_;
  std::unique_ptr<Planner> planner_;
  const SearchPlanner* search_;
  bool registered_ = false;
};

}  // namespace mpmstudy
