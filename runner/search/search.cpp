#include "runner/search/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "libmpm/scene/parameters.hpp"
#include "runner/plan/plan.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

/// Runs of a round that are aimed at: one value per point, which needs the fewest runs; two where few points
/// are left and workers would wait. A constant, not the number of workers: rounds must not depend on the
/// machine.
constexpr int runs_a_round = 4;
constexpr int most_values = 2;

const mpm::Quantity* axis_of(const Study& study) {
  for (const std::string& name : study.swept)
    if (name != "cell_size")
      if (const mpm::Quantity* q = mpm::find_quantity(name);
          q && std::ranges::find(study.own, name, &OwnParameter::name) == study.own.end())
        return q;
  return nullptr;
}

/// What else is swept, axis and cell apart: equal for the points of a family.
std::vector<double> family_of(const Study& study, const mpm::Scene& scene, const mpm::Quantity* axis) {
  std::vector<double> values;
  for (const std::string& name : study.swept) {
    if (name == "cell_size" || (axis && name == axis->name)) continue;
    values.push_back(parameter_number(scene, name));
  }
  return values;
}

}  // namespace

Search::Search(const Study& study)
    : critical_(study),
      values_(study.search->lower, study.search->upper, study.search->tolerance),
      half_(values_) {
  half_.intervals *= 2;
  const mpm::Quantity* axis = axis_of(study);
  std::map<std::vector<double>, std::size_t> families;
  std::set<std::string> points;  // a value that the sweep has twice is searched once
  for (std::size_t position = 0; position < study.scenes.size(); ++position) {
    const mpm::Scene& scene = study.scenes[position];
    if (!points.insert(job_key(scene)).second) continue;
    const std::size_t family = families.emplace(family_of(study, scene, axis), families.size()).first->second;
    SearchPoint point{scene, family, axis ? axis->get(scene) : 0, scene.numerics.cell_size, position};
    entries_.push_back({std::move(point), {}, {}, {}});
  }
  std::ranges::stable_sort(entries_,
                           [](const Entry& a, const Entry& b) { return a.point.cell > b.point.cell; });
}

mpm::Scene Search::scene_at(const Entry& entry, int half_steps) const {
  mpm::Scene scene = entry.point.scene;
  critical_.set(scene, half_.value(half_steps));
  return scene;
}

std::optional<Bracket> Search::Entry::bracket() const {
  if (!search) return std::nullopt;
  if (between) return between->bracket();
  const auto found = search->bracket();
  return found ? std::optional(Bracket{2 * found->lower, 2 * found->upper}) : std::nullopt;
}

std::vector<int> Search::Entry::next(int most) const {
  if (!search) return {};
  if (between) return between->next(1);  // few steps are left: of two runs at once one would often be wasted
  auto indices = search->next(most);
  for (int& index : indices) index *= 2;
  return indices;
}

/// Runs that failed inside the bracket leave it wider than the tolerance: values half a step from them are
/// tried too.
void Search::start_between(Entry& entry) const {
  if (!entry.search || entry.between || !entry.search->finished()) return;
  const auto found = entry.search->bracket();
  if (!found || found->upper - found->lower == 1) return;
  entry.between.emplace(half_.intervals);
  for (const auto& [index, told] : entry.search->told())
    entry.between->tell(2 * index, told.verdict, told.distance);
}

/// Middle of a bracket that has been found [index of SearchValues].
std::optional<double> Search::found_at(std::size_t family, double along, double cell) const {
  for (const Entry& e : entries_)
    if (e.point.family == family && e.point.along == along && e.point.cell == cell && e.finished())
      if (const auto b = e.bracket()) return 0.25 * (b->lower + b->upper);
  return std::nullopt;
}

/// Where to begin: where the next coarser cell has it; the line through two coarser cells was no better
/// (critical speeds scatter about any line in the cell). On the coarsest cell: on the straight line between
/// the neighbours that are found. The step is what was seen to be left: a thirtieth, or half of what the
/// cells before differ by.
std::optional<Guess> Search::guess(const Entry& entry) const {
  const SearchPoint& p = entry.point;
  const auto begin = [this](double at, double last_change) {
    const double value = values_.lower + (values_.upper - values_.lower) * at / values_.intervals;
    const double share = value / 30 / (values_.upper - values_.lower) * values_.intervals;
    return Guess{static_cast<int>(std::lround(at)),
                 static_cast<int>(std::lround(std::max({2.0, share, 0.5 * std::abs(last_change)})))};
  };
  std::vector<double> coarser;  // indices, coarse first
  for (const Entry& e : entries_)
    if (e.point.cell > p.cell && e.point.family == p.family && e.point.along == p.along)
      if (const auto middle = found_at(p.family, p.along, e.point.cell)) coarser.push_back(*middle);
  if (coarser.size() == 1) return begin(coarser[0], 0);
  if (coarser.size() > 1) return begin(coarser.back(), coarser.back() - coarser[coarser.size() - 2]);
  std::optional<std::pair<double, double>> left, right;
  for (const Entry& e : entries_) {
    if (e.point.family != p.family || e.point.cell != p.cell) continue;
    const auto middle = found_at(p.family, e.point.along, p.cell);
    if (!middle) continue;
    if (e.point.along < p.along && (!left || e.point.along > left->first)) left = {e.point.along, *middle};
    if (e.point.along > p.along && (!right || e.point.along < right->first)) right = {e.point.along, *middle};
  }
  if (!left || !right) return std::nullopt;
  return begin(
      left->second + (right->second - left->second) * (p.along - left->first) / (right->first - left->first),
      0);
}

/// Starts the searches whose guesses are there. On the coarsest cell both ends of the axis begin without one,
/// and the points between them wait. A finer cell waits for the next coarser one of all points: a round lasts
/// as long as its longest run, so runs of one cell share it.
void Search::start_ready() {
  for (Entry& e : entries_) {
    if (e.search) continue;
    bool waits = false, left = false, right = false, coarsest = true;
    for (const Entry& other : entries_) {
      if (other.point.family != e.point.family) continue;
      const bool open = !other.finished();
      if (other.point.cell > e.point.cell) {
        coarsest = false;
        waits |= open;
      }
      if (other.point.cell != e.point.cell) continue;
      left |= other.point.along < e.point.along;
      right |= other.point.along > e.point.along;
    }
    if (coarsest && left && right)  // the ends of the axis first
      for (const Entry& other : entries_) {
        if (other.point.family != e.point.family || other.point.cell != e.point.cell) continue;
        bool end_left = true, end_right = true;
        for (const Entry& third : entries_) {
          if (third.point.family != e.point.family || third.point.cell != e.point.cell) continue;
          end_left &= third.point.along >= other.point.along;
          end_right &= third.point.along <= other.point.along;
        }
        if (end_left || end_right) waits |= !other.finished();
      }
    if (!waits) e.search.emplace(values_.intervals, guess(e));
  }
}

/// Why the entry goes on, from what it has been told.
std::string Search::why(const Entry& entry) const {
  if (entry.between) return "runs failed inside the bracket; half a step from them";
  if (const auto found = entry.bracket()) {
    const std::string_view unit = critical_.quantity().unit;
    return fmt::format("the critical value lies between {} and {}", readable(half_.value(found->lower), unit),
                       readable(half_.value(found->upper), unit));
  }
  const auto& told = entry.search->told();
  if (told.empty())
    return entry.search->has_guess() ? "where coarser cells or neighbours have the critical value"
                                     : "the first values, over the whole range";
  const auto any = [&](auto... verdicts) {
    return std::ranges::any_of(told,
                               [&](const auto& run) { return ((run.second.verdict == verdicts) || ...); });
  };
  if (any(Verdict::above)) return "no run is below the critical value yet";
  if (any(Verdict::below, Verdict::undecided)) return "no run is above the critical value yet";
  return "no run has a verdict yet";
}

std::vector<AskedScene> Search::next_round() {
  for (Entry& e : entries_) start_between(e);
  start_ready();
  int active = 0;
  for (const Entry& e : entries_) active += e.search && !e.finished();
  if (active == 0) return {};
  const int values = std::clamp(runs_a_round / active, 1, most_values);
  std::vector<AskedScene> scenes;
  for (Entry& e : entries_) {
    const auto indices = e.next(values);
    const std::string reason = indices.empty() ? "" : why(e);
    for (const int index : indices) {
      scenes.push_back({scene_at(e, index), reason});
      e.runs.emplace_back(index, job_key(scenes.back().scene));
    }
  }
  return scenes;
}

void Search::tell(const std::string& key, Verdict verdict, double distance) {
  for (Entry& e : entries_)
    for (const auto& [index, run] : e.runs)
      if (run == key) {
        if (e.between)
          e.between->tell(index, verdict, distance);
        else
          e.search->tell(index / 2, verdict, distance);
      }
}

std::vector<FoundBracket> Search::brackets() const {
  std::vector<FoundBracket> all;
  for (const Entry& e : entries_) {
    FoundBracket found{e.point, {}, {}, {}, {}, "not searched", static_cast<int>(e.runs.size())};
    if (e.search) {
      found.flags = e.between ? e.between->flags(half_, critical_.quantity().unit)
                              : e.search->flags(values_, critical_.quantity().unit);
      if (const auto bracket = e.bracket()) {
        for (const auto& [index, key] : e.runs) {
          if (index == bracket->lower) found.lower_key = key;
          if (index == bracket->upper) found.upper_key = key;
        }
        found.lower = half_.value(bracket->lower);
        found.upper = half_.value(bracket->upper);
      }
    }
    all.push_back(std::move(found));
  }
  return all;
}

}  // namespace mpmstudy
