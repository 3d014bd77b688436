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

BracketSearch::BracketSearch(int intervals, std::optional<int> guess)
    : intervals_(intervals), guess_(guess) {}

void BracketSearch::tell(int index, Verdict verdict) { verdicts_[index] = verdict; }

std::optional<Bracket> BracketSearch::bracket() const {
  std::optional<int> lower;
  for (const auto& [index, verdict] : verdicts_) {
    if (verdict == Verdict::broken) continue;
    if (verdict == Verdict::above) return lower ? std::optional(Bracket{*lower, index}) : std::nullopt;
    lower = index;
  }
  return std::nullopt;
}

/// Nothing or one side is known: steps away from it that double.
std::vector<int> BracketSearch::outwards() const {
  constexpr int first_step = 2;
  int steps = 0, low = intervals_ + 1, high = -1;
  bool above = false;
  for (const auto& [index, verdict] : verdicts_) {
    ++steps;
    low = std::min(low, index), high = std::max(high, index);
    above |= verdict == Verdict::above;
  }
  const int step = first_step << std::min(steps, 20);
  const int next = above ? std::max(0, low - step) : std::min(intervals_, high + step);
  return known(next) ? std::vector<int>{} : std::vector<int>{next};
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
  if (const auto found = bracket()) return inwards(found->lower, found->upper, std::max(1, most));
  if (!verdicts_.empty()) return outwards();
  if (!guess_) return inwards(-1, intervals_ + 1, std::max(3, most));
  const int low = std::max(0, *guess_ - 1), high = std::min(intervals_, *guess_ + 1);
  return {low, high};
}

std::string BracketSearch::flags(const Lattice& lattice) const {
  const auto found = bracket();
  std::string text;
  const auto add = [&text](const std::string& flag) { text += (text.empty() ? "" : "; ") + flag; };
  if (!found) {
    bool above = false;
    for (const auto& [index, verdict] : verdicts_) above |= verdict == Verdict::above;
    add(above ? "no lower end" : "no upper end");
  }
  for (const auto& [index, verdict] : verdicts_) {
    const auto value = fmt::format("{:.6g}", lattice.value(index));
    if (verdict == Verdict::broken) add("failed at " + value);
    if (found && index > found->upper && verdict != Verdict::above && verdict != Verdict::broken)
      add("flips back at " + value);
    if (found && index == found->lower && verdict == Verdict::undecided) add("lower end undecided");
  }
  return text;
}

}  // namespace mpmstudy
