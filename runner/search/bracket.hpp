#pragma once
/// The search for one critical value among equally spaced ones. Pure: it is told verdicts and says what to
/// try next.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mpmstudy {

/// Equally spaced values from lower to upper, no farther apart than the tolerance. Every search of a study
/// tries these values only: searches that come together ask for the same jobs.
struct SearchValues {
  double lower = 0, upper = 0;
  int intervals = 1;

  SearchValues() = default;
  /// Throws std::invalid_argument for more than most_search_steps.
  SearchValues(double lower, double upper, double tolerance);
  double value(int i) const { return lower + (upper - lower) * i / intervals; }
  /// The index of the nearest one.
  int index(double value) const;
};

/// What a run says of a value.
enum class Verdict {
  below,      ///< the outcome that is looked for did not happen
  above,      ///< it did
  undecided,  ///< it had not happened when the run ended; counts as below, and is flagged
  broken      ///< the run failed: the value is left out
};

/// Two neighbouring values of which the lower does not have the outcome and the upper has it.
struct Bracket {
  int lower = 0, upper = 0;  ///< indices of SearchValues
};

/// Where a value is thought to be, and how far from it to step if it is not there; indices of SearchValues.
struct Guess {
  int at = 0, step = 2;
};

class BracketSearch {
 public:
  /// Without a guess all values are searched.
  explicit BracketSearch(int intervals, std::optional<Guess> guess = {});

  /// `distance`: how far the run was from the other verdict, in any one measure, 0 if it is not known.
  void tell(int index, Verdict, double distance = 0);
  /// What to try next, at most `most` values (without a guess at least three to begin with); empty: nothing
  /// is left to try. Depends on nothing but what was told. Between two ends one value is half way between
  /// their middle and where the straight line through their distances changes sign: distances tell where to
  /// look, but not how far along a straight line.
  std::vector<int> next(int most) const;

  /// Smallest value above and the largest below it; empty until both are known.
  std::optional<Bracket> bracket() const;
  bool finished() const { return next(1).empty(); }
  /// What a reader of the bracket has to know: "flips back at 410 m/s", "lower end undecided", "no
  /// upper end"; "" if nothing. In the unit of the values.
  std::string flags(const SearchValues&, std::string_view unit) const;

  struct Told {
    Verdict verdict = Verdict::broken;
    double distance = 0;
  };
  const std::map<int, Told>& told() const { return told_; }
  bool has_guess() const { return guess_.has_value(); }

 private:
  bool known(int index) const { return told_.contains(index); }
  std::vector<int> outwards() const;
  std::vector<int> downwards(int above) const;
  std::vector<int> upwards(int below) const;
  std::vector<int> without_verdict() const;
  std::vector<int> inwards(int low, int high, int most) const;
  int between(const Bracket&) const;

  int intervals_;
  std::optional<Guess> guess_;
  std::map<int, Told> told_;
};

}  // namespace mpmstudy
