#pragma once
/// The runs of a study with a [surface], round by round.
#include <vector>

#include "runner/plan/planner.hpp"

namespace mpmstudy {

/// First the jobs of the design. Then, when all that was asked for is decided and the tolerance does not
/// hold, a batch of runs where they tell the surface most, until it holds or the budget is spent. Which ones
/// follows from the results alone.
class SurfacePlanner : public Planner {
 public:
  /// Of a study with a [surface].
  SurfacePlanner(const Study&, const Plan&);
  std::vector<Job> next(const Answers&) override;

 private:
  Study study_;
  std::vector<Job> candidates_;
  std::vector<Job> jobs_;  ///< all that were asked for; before the first time, that will be
  bool begun_ = false, ended_ = false;
  int round_ = 0;
};

}  // namespace mpmstudy
