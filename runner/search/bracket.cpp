#include "runner/search/bracket.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "runner/study/searched.hpp"

namespace mpmstudy {

namespace {

/// After so many runs without any verdict the search ends: the others will hardly have one.
constexpr std::size_t most_blind = 9;
/// So many failed runs between the ends of a bracket leave it as wide as it is.
constexpr int most_broken = 12;

}  // namespace

SearchValues::SearchValues(double low, double high, double tolerance) : lower(low), upper(high) {
  const double steps = search_steps(low, high, tolerance);
  if (!(steps <= most_search_steps))
    throw std::invalid_argument(
        fmt::format("{:g} steps of a search, at most {:g}", steps, most_search_steps));
  intervals = static_cast<int>(steps);
}

int SearchValues::index(double v) const {
  const double i = std::round((v - lower) / (upper - lower) * intervals);
  return static_cast<int>(std::clamp(i, 0.0, static_cast<double>(intervals)));
}

BracketSearch::BracketSearch(int intervals, std::optional<Guess> guess)
    : intervals_(intervals), guess_(guess) {}

void BracketSearch::tell(int index, Verdict verdict, double distance) {
  told_[index] = {verdict, std::abs(distance)};
}

std::optional<Bracket> BracketSearch::bracket() const {
  std::optional<int> lower;
  for (const auto& [index, told] : told_) {
    if (told.verdict == Verdict::broken) continue;
    if (told.verdict == Verdict::above) return lower ? std::optional(Bracket{*lower, index}) : std::nullopt;
    lower = index;
  }
  return std::nullopt;
}

/// One side is known, or none: steps away from what is known, as long as that is wide, so that they double.
std::vector<int> BracketSearch::outwards() const {
  std::optional<int> above, below;
  for (const auto& [index, told] : told_) {
    if (told.verdict == Verdict::broken) continue;
    if (told.verdict != Verdict::above)
      below = index;
    else if (!above)
      above = index;
  }
  if (above) return downwards(*above);
  if (below) return upwards(*below);
  return without_verdict();
}

/// No lower end yet. Where the runs down to the lowest value have failed, between them and the value above.
std::vector<int> BracketSearch::downwards(int above) const {
  const int low = told_.begin()->first, high = told_.rbegin()->first;
  const int next = std::max(0, low - std::max(guess_ ? guess_->step : 2, high - low));
  if (!known(next)) return {next};
  const auto at = told_.find(above);
  if (at == told_.begin()) return {};
  const int broken = std::prev(at)->first;
  return above - broken > 1 ? std::vector<int>{broken + (above - broken) / 2} : std::vector<int>{};
}

/// The same for the upper end.
std::vector<int> BracketSearch::upwards(int below) const {
  const int low = told_.begin()->first, high = told_.rbegin()->first;
  const int next = std::min(intervals_, high + std::max(guess_ ? guess_->step : 2, high - low));
  if (!known(next)) return {next};
  const auto beyond = told_.upper_bound(below);
  if (beyond == told_.end()) return {};
  const int broken = beyond->first;
  return broken - below > 1 ? std::vector<int>{below + (broken - below) / 2} : std::vector<int>{};
}

/// All runs have failed: to one end, to the other, then into the widest gap.
std::vector<int> BracketSearch::without_verdict() const {
  const int low = told_.begin()->first, high = told_.rbegin()->first;
  const int step = std::max(guess_ ? guess_->step : 2, high - low);
  for (const int next : {std::min(intervals_, high + step), std::max(0, low - step)})
    if (!known(next)) return {next};
  if (told_.size() >= most_blind) return {};
  int from = 0, width = 1;
  for (auto at = told_.begin(); std::next(at) != told_.end(); ++at)
    if (const int gap = std::next(at)->first - at->first; gap > width) from = at->first, width = gap;
  return width > 1 ? std::vector<int>{from + width / 2} : std::vector<int>{};
}

int BracketSearch::between(const Bracket& ends) const {
  const double below = told_.at(ends.lower).distance, above = told_.at(ends.upper).distance;
  const double share = below + above > 0 ? below / (below + above) : 0.5;
  const double at = ends.lower + (ends.upper - ends.lower) * 0.5 * (share + 0.5);
  return std::clamp(static_cast<int>(std::lround(at)), ends.lower + 1, ends.upper - 1);
}

/// Evenly spaced between the ends; values that broke are passed over.
std::vector<int> BracketSearch::inwards(int low, int high, int most) const {
  std::vector<int> open;
  for (int i = low + 1; i < high; ++i)
    if (!known(i)) open.push_back(i);
  const int count = std::min(most, static_cast<int>(open.size()));
  std::vector<int> values;
  for (int k = 1; k <= count; ++k)
    values.push_back(open[(open.size() * static_cast<std::size_t>(k)) / static_cast<std::size_t>(count + 1)]);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::vector<int> BracketSearch::next(int most) const {
  if (const auto found = bracket()) {
    int broken = 0;
    for (auto at = told_.upper_bound(found->lower); at->first < found->upper; ++at) ++broken;
    if (broken >= most_broken) return {};
    if (most == 1 && found->upper - found->lower > 1)
      if (const int index = between(*found); !known(index)) return {index};
    return inwards(found->lower, found->upper, std::max(1, most));
  }
  if (!told_.empty()) return outwards();
  if (!guess_) return inwards(-1, intervals_ + 1, std::max(3, most));
  const int at = std::clamp(guess_->at, 0, intervals_);
  if (most == 1) return {at};
  return {std::max(0, at - (guess_->step + 1) / 2), std::min(intervals_, at + (guess_->step + 1) / 2)};
}

std::string BracketSearch::flags(const SearchValues& values, std::string_view unit) const {
  const auto found = bracket();
  std::string text;
  const auto add = [&text](const std::string& flag) { text += (text.empty() ? "" : "; ") + flag; };
  if (!found) {
    bool above = false, below = false;
    for (const auto& [index, told] : told_) {
      above |= told.verdict == Verdict::above;
      below |= told.verdict == Verdict::below || told.verdict == Verdict::undecided;
    }
    add(above ? "no lower end" : below ? "no upper end" : "no run has a verdict");
  }
  for (const auto& [index, told] : told_) {
    const Verdict verdict = told.verdict;
    const auto value =
        fmt::format("{:.6g}{}{}", values.value(index), unit == "1" ? "" : " ", unit == "1" ? "" : unit);
    if (verdict == Verdict::broken) add("failed at " + value);
    if (found && index > found->upper && verdict != Verdict::above && verdict != Verdict::broken)
      add("flips back at " + value);
    if (found && index == found->lower && verdict == Verdict::undecided) add("lower end undecided");
  }
  return text;
}

}  // namespace mpmstudy
