#pragma once
/// What a search will run, before it has run: made-up verdicts in place of those that are not known yet.
#include <vector>

#include "runner/plan/planner.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

struct SearchForecast {
  /// Scenes that would run, round by round, if the critical values lay in the middle of the searched values.
  std::vector<std::vector<mpm::Scene>> rounds;
  int runs = 0;              ///< of these
  int fewest = 0, most = 0;  ///< over critical values from the least to the largest that is searched
};

/// Plays the search through for critical values at several of the searched values; once some points or cells
/// are known, for values like theirs. They are as far from where the search begins to look as was seen in
/// real ones: up to a thirtieth. Runs whose verdicts are known are not counted.
/// Null: nothing is known.
SearchForecast forecast_search(const Study&, const Answers* known = nullptr);

}  // namespace mpmstudy
