#include "runner/search/bracket.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mpmstudy {

Lattice::Lattice(double low, double high, double tolerance)
    : lower(low),
      upper(high),
      intervals(std::max(1, static_cast<int>(std::ceil((high - low) / tolerance - 1e-9)))) {}

int Lattice::index(double v) const {
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

/// One side is known: steps away from it, as long as what is known is wide, so that they double.
std::vector<int> BracketSearch::outwards() const {
  const int low = told_.begin()->first, high = told_.rbegin()->first;
  const bool above =
      std::ranges::any_of(told_, [](const auto& t) { return t.second.verdict == Verdict::above; });
  const int step = std::max(guess_ ? guess_->step : 2, high - low);
  const int next = above ? std::max(0, low - step) : std::min(intervals_, high + step);
  return known(next) ? std::vector<int>{} : std::vector<int>{next};
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

std::string BracketSearch::flags(const Lattice& lattice) const {
  const auto found = bracket();
  std::string text;
  const auto add = [&text](const std::string& flag) { text += (text.empty() ? "" : "; ") + flag; };
  if (!found) {
    bool above = false;
    for (const auto& [index, told] : told_) above |= told.verdict == Verdict::above;
    add(above ? "no lower end" : "no upper end");
  }
  for (const auto& [index, told] : told_) {
    const Verdict verdict = told.verdict;
    const auto value = fmt::format("{:.6g}", lattice.value(index));
    if (verdict == Verdict::broken) add("failed at " + value);
    if (found && index > found->upper && verdict != Verdict::above && verdict != Verdict::broken)
      add("flips back at " + value);
    if (found && index == found->lower && verdict == Verdict::undecided) add("lower end undecided");
  }
  return text;
}

}  // namespace mpmstudy
