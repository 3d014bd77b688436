#pragma once
/// The runs of a [search], round by round, and those of its audit.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "runner/plan/planner.hpp"
#include "runner/search/search.hpp"

namespace mpmstudy {

/// What an answer says to a search for an outcome.
Verdict verdict_of(const Answer&, const std::string& outcome);

/// Every round waits for the answers of the one before.
class SearchPlanner : public Planner {
 public:
  explicit SearchPlanner(const Study&, CostModel = {});
  std::vector<Job> next(const Answers&) override;

  bool ended() const { return ended_; }
  /// Jobs that were asked for and whose answers were not there when it was last asked.
  std::int64_t waits_for() const { return static_cast<std::int64_t>(jobs_.size() - told_); }
  std::vector<FoundBracket> brackets() const { return search_.brackets(); }
  const std::vector<Job>& jobs() const { return jobs_; }  ///< all that were asked for

 private:
  std::string outcome_;
  CostModel cost_;
  Search search_;
  std::vector<Job> jobs_;
  std::size_t told_ = 0;  ///< of jobs_: those whose verdicts the search has
  int round_ = 0;
  bool ended_ = false;
};

/// A run that stopped early, and the same run to its end.
struct AuditedRun {
  std::string early;
  Job whole;
};

/// Of the jobs of a search that were to stop when decided, those that an audit runs to their end: a share of
/// those that are done, chosen by their keys, so that they are the same ones every time.
struct AuditSample {
  std::int64_t early = 0;  ///< how many of the jobs are done and were to stop
  std::vector<AuditedRun> runs;
};
AuditSample audit_sample(const std::vector<Job>&, double share, const CostModel&, const Answers&);

/// Of all scenes that the search, or its audit, may ask for, whatever the runs say: those whose keys are
/// wanted. There may be too many for a list of all.
std::vector<mpm::Scene> possible_scenes(const Study&,
                                        const std::function<bool(const std::string& key)>& wanted);

}  // namespace mpmstudy
