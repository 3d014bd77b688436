#include "runner/search/search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "libmpm/scene/parameters.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {
namespace {

/// Runs of a round that are aimed at: one value a point, which needs the fewest runs; two where few points
/// are left and workers would wait. A constant, not the number of workers: rounds must not depend on the
/// machine.
constexpr int runs_a_round = 4;
constexpr int most_values = 2;

const mpm::Quantity* axis_of(const Study& study) {
  for (const std::string& name : study.swept)
    if (name != "cell_size")
      if (const mpm::Quantity* q = mpm::find_quantity(name)) return q;
  return nullptr;
}

/// The scene with the axis and the cell taken out: equal for the points of a family.
std::string family_of(mpm::Scene scene, const mpm::Quantity* axis) {
  if (axis) axis->set(scene, 0);
  scene.numerics.cell_size = 0;
  return canonical_text(scene);
}

}  // namespace

Search::Search(const Study& study)
    : critical_(mpm::find_quantity(study.search->critical)),
      lattice_(study.search->lower, study.search->upper, study.search->tolerance) {
  const mpm::Quantity* axis = axis_of(study);
  std::map<std::string, std::size_t> families;
  for (const mpm::Scene& scene : study.scenes) {
    const std::size_t family = families.emplace(family_of(scene, axis), families.size()).first->second;
    SearchPoint point{scene, family, axis ? axis->get(scene) : 0, scene.numerics.cell_size, entries_.size()};
    entries_.push_back({std::move(point), {}, {}});
  }
  std::ranges::stable_sort(entries_,
                           [](const Entry& a, const Entry& b) { return a.point.cell > b.point.cell; });
}

mpm::Scene Search::scene_at(const Entry& entry, int index) const {
  mpm::Scene scene = entry.point.scene;
  critical_->set(scene, lattice_.value(index));
  return scene;
}

/// Middle of a bracket that has been found [index of the lattice].
std::optional<double> Search::found_at(std::size_t family, double along, double cell) const {
  for (const Entry& e : entries_)
    if (e.point.family == family && e.point.along == along && e.point.cell == cell && e.search)
      if (const auto b = e.search->bracket(); b && e.search->finished()) return 0.5 * (b->lower + b->upper);
  return std::nullopt;
}

/// Where to begin. With two coarser cells of the same point: between the finer of them and where the straight
/// line through both has this cell (first order); critical values shift by less than that. With one: around
/// it. On the coarsest cell: around the straight line between the neighbours that are found.
std::optional<Bracket> Search::guess(const Entry& entry) const {
  constexpr double around = 2;
  const auto between = [](double a, double b) {
    const auto [low, high] = std::minmax(a, b);
    const double widen = std::max(0.0, around - (high - low)) / 2;
    return Bracket{static_cast<int>(std::floor(low - widen)), static_cast<int>(std::ceil(high + widen))};
  };
  const SearchPoint& p = entry.point;
  std::vector<std::pair<double, double>> coarser;  // cell, index; coarse first
  for (const Entry& e : entries_)
    if (e.point.cell > p.cell)
      if (const auto middle = found_at(p.family, p.along, e.point.cell);
          middle && e.point.family == p.family && e.point.along == p.along)
        coarser.emplace_back(e.point.cell, *middle);
  if (coarser.size() == 1) return between(coarser[0].second - around, coarser[0].second + around);
  if (coarser.size() > 1) {
    const auto [h1, y1] = coarser[coarser.size() - 2];
    const auto [h2, y2] = coarser.back();
    return between(y2, y2 + (y2 - y1) * (h2 - p.cell) / (h1 - h2));
  }
  std::optional<std::pair<double, double>> left, right;
  for (const Entry& e : entries_) {
    if (e.point.family != p.family || e.point.cell != p.cell) continue;
    const auto middle = found_at(p.family, e.point.along, p.cell);
    if (!middle) continue;
    if (e.point.along < p.along && (!left || e.point.along > left->first)) left = {e.point.along, *middle};
    if (e.point.along > p.along && (!right || e.point.along < right->first)) right = {e.point.along, *middle};
  }
  if (!left || !right) return std::nullopt;
  const double line =
      left->second + (right->second - left->second) * (p.along - left->first) / (right->first - left->first);
  return between(line - around, line + around);
}

/// Starts the searches whose guesses are there. On the coarsest cell both ends of the axis begin without one,
/// and the points between them wait; a finer cell waits for the next coarser one.
void Search::start_ready() {
  for (Entry& e : entries_) {
    if (e.search) continue;
    bool waits = false, left = false, right = false, coarsest = true;
    for (const Entry& other : entries_) {
      if (other.point.family != e.point.family) continue;
      const bool open = !other.search || !other.search->finished();
      if (other.point.along == e.point.along && other.point.cell > e.point.cell) {
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
        if (end_left || end_right) waits |= !other.search || !other.search->finished();
      }
    if (!waits) e.search.emplace(lattice_.intervals, guess(e));
  }
}

std::vector<mpm::Scene> Search::next_round() {
  start_ready();
  int active = 0;
  for (const Entry& e : entries_) active += e.search && !e.search->finished();
  if (active == 0) return {};
  const int values = std::clamp(runs_a_round / active, 1, most_values);
  std::vector<mpm::Scene> scenes;
  for (Entry& e : entries_) {
    if (!e.search) continue;
    for (const int index : e.search->next(values)) {
      scenes.push_back(scene_at(e, index));
      e.runs.emplace_back(index, job_key(scenes.back()));
    }
  }
  return scenes;
}

void Search::tell(const std::string& key, Verdict verdict, double distance) {
  for (Entry& e : entries_)
    for (const auto& [index, run] : e.runs)
      if (run == key) e.search->tell(index, verdict, distance);
}

std::vector<FoundBracket> Search::brackets() const {
  std::vector<FoundBracket> all;
  for (const Entry& e : entries_) {
    FoundBracket found{e.point, {}, {}, {}, {}, "not searched", static_cast<int>(e.runs.size())};
    if (e.search) {
      found.flags = e.search->flags(lattice_);
      if (const auto bracket = e.search->bracket()) {
        found.lower = lattice_.value(bracket->lower);
        found.upper = lattice_.value(bracket->upper);
        for (const auto& [index, key] : e.runs) {
          if (index == bracket->lower) found.lower_key = key;
          if (index == bracket->upper) found.upper_key = key;
        }
      }
    }
    all.push_back(std::move(found));
  }
  return all;
}

}  // namespace mpmstudy
