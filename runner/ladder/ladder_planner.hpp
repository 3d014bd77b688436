#pragma once
/// The ladders of a study that an accuracy makes climb.
#include <vector>

#include "runner/ladder/climb.hpp"
#include "runner/plan/planner.hpp"

namespace mpmstudy {

/// First the jobs of the plan. Then one finer cell at a time under each job whose interval is not inside the
/// accuracy; no ladder waits for the rungs of another one.
class LadderPlanner : public Planner {
 public:
  explicit LadderPlanner(const Plan&);
  std::vector<Job> next(const Answers&) override;

 private:
  struct Ladder {
    std::vector<Job> rungs;         ///< coarse to fine: all that there may be
    std::vector<RungState> states;  ///< of those that were asked for
  };
  void look(Ladder&, const Answers&) const;
  void climb(Ladder&, const Answers&, std::vector<Job>& wanted) const;

  LadderRequest request_;
  std::vector<Job> first_;  ///< empty once it was asked for
  std::vector<Ladder> ladders_;
};

}  // namespace mpmstudy
