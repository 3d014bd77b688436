#pragma once
/// [search]: critical values of a study, found by rounds of runs. Pure but for what it is told: no clock, no
/// disk, no catalog. A round depends on the verdicts of the rounds before it and on nothing else, so brackets
/// are the same for any number of workers, and a search that is started again asks for the same jobs, which
/// the catalog has.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/search/bracket.hpp"
#include "runner/study/searched.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// One place where a critical value is looked for: a scene without it.
struct SearchPoint {
  mpm::Scene scene;          ///< `critical` is to be set
  std::size_t family = 0;    ///< of points that differ along the axis alone
  double along = 0;          ///< value of the axis that neighbours lie on
  double cell = 0;           ///< [m]
  std::size_t position = 0;  ///< in the study's sweep
};

/// A found bracket with the runs that prove it. Empty ends: see flags.
struct FoundBracket {
  SearchPoint point;
  std::optional<double> lower, upper;
  std::string lower_key, upper_key;
  std::string flags;
  int runs = 0;
};

/// A scene that a search asks for.
struct AskedScene {
  mpm::Scene scene;
  std::string why;  ///< for people
};

class Search {
 public:
  /// The study has a [search]. Neighbours lie along its first swept quantity other than cell_size; every
  /// other combination of what is swept is a family. Cells are searched from the coarsest on.
  explicit Search(const Study&);

  /// Scenes of the next round, each once; empty: the search has ended. Call tell() for each of them first.
  std::vector<AskedScene> next_round();
  /// key: job_key of a scene of the last round; failed jobs are Verdict::broken. `distance`: see
  /// BracketSearch.
  void tell(const std::string& key, Verdict, double distance = 0);

  std::vector<FoundBracket> brackets() const;

 private:
  struct Entry {
    SearchPoint point;
    std::optional<BracketSearch> search;  ///< empty: waits for its guess
    /// On half steps, once runs that failed have left the bracket wider than a step.
    std::optional<BracketSearch> between;
    std::vector<std::pair<int, std::string>> runs;  ///< index in half steps, key

    bool finished() const { return search && (between ? between->finished() : search->finished()); }
    /// In half steps.
    std::optional<Bracket> bracket() const;
    /// Indices in half steps.
    std::vector<int> next(int most) const;
  };
  mpm::Scene scene_at(const Entry&, int half_steps) const;
  std::string why(const Entry&) const;
  void start_between(Entry&) const;
  void start_ready();
  std::optional<Guess> guess(const Entry&) const;
  std::optional<double> found_at(std::size_t family, double along, double cell) const;

  Searched critical_;
  SearchValues values_, half_;  ///< steps, and half steps
  std::vector<Entry> entries_;  ///< coarse cells first, in the order of the study
};

}  // namespace mpmstudy
