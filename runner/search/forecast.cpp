#include "runner/search/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "libmpm/scene/parameters.hpp"
#include "runner/plan/plan.hpp"
#include "runner/search/search.hpp"
#include "runner/search/search_planner.hpp"
#include "runner/study/searched.hpp"

namespace mpmstudy {
namespace {

using Rounds = std::vector<std::vector<mpm::Scene>>;

/// Made-up critical values: those that other cells of the point are known to have, else about the mean of
/// what is known of other points, else about one value. Each differs a little from that, and
/// never contradicts what is known of the point itself.
class MadeUpValues {
 public:
  MadeUpValues(const Study& study, double place) : critical_(study), lower_(study.search->lower) {
    const SearchRequest& request = *study.search;
    const double width = request.upper - request.lower;
    middle_ = request.lower + place * width;
    step_ = width / search_steps(request.lower, request.upper, request.tolerance);
  }

  void learn(const mpm::Scene& scene, Verdict verdict) {
    if (verdict == Verdict::broken) return;
    auto& [below, above] = known_[point_of(scene)][scene.numerics.cell_size];
    const double value = critical_.quantity().get(scene);
    if (verdict == Verdict::above)
      above = std::min(above, value);
    else
      below = std::max(below, value);
  }

  Verdict verdict_of(const mpm::Scene& scene) {
    const std::string point = point_of(scene);
    const double value = critical_.quantity().get(scene);
    const auto& [below, above] = known_[point][scene.numerics.cell_size];
    if (value <= below) return Verdict::below;
    if (value >= above) return Verdict::above;
    const double middle = mean(known_[point]).value_or(mean_of_all().value_or(middle_));
    const double scatter = std::max(2 * step_, std::abs(middle) / 30);
    const double turns =
        static_cast<double>(std::stoul(point.substr(0, 4), nullptr, 16) % 5) - 2;  // -2 ... 2
    return value > middle + 0.5 * turns * scatter ? Verdict::above : Verdict::below;
  }

 private:
  struct Ends {
    double below = -std::numeric_limits<double>::infinity(), above = std::numeric_limits<double>::infinity();
  };
  using Cells = std::map<double, Ends>;

  /// Of the brackets that have both ends.
  static std::optional<double> mean(const Cells& cells) {
    double sum = 0;
    int count = 0;
    for (const auto& [cell, ends] : cells)
      if (std::isfinite(ends.below) && std::isfinite(ends.above)) {
        sum += 0.5 * (ends.below + ends.above);
        ++count;
      }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
  }
  std::optional<double> mean_of_all() const {
    double sum = 0;
    int count = 0;
    for (const auto& [point, cells] : known_)
      if (const auto one = mean(cells)) {
        sum += *one;
        ++count;
      }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
  }
  /// A name for the scene without its critical value and its cell.
  std::string point_of(mpm::Scene scene) const {
    critical_.set(scene, lower_);
    scene.numerics.cell_size = 0;
    return job_key(scene);
  }

  const Searched critical_;
  double lower_ = 0, middle_ = 0, step_ = 0;
  std::map<std::string, Cells> known_;
};

/// The search with critical values about one place; the scenes that are not known yet, round by round.
Rounds play(const Study& study, const Answers* known, double place) {
  MadeUpValues values(study, place);
  Rounds rounds;
  Search search(study);
  for (auto scenes = search.next_round(); !scenes.empty(); scenes = search.next_round()) {
    std::vector<mpm::Scene> open;
    for (const auto& [scene, why] : scenes) {
      const std::string key = job_key(scene);
      const auto answer = known ? known->of(key) : std::nullopt;
      std::optional<Verdict> verdict;
      if (answer) verdict = verdict_of(*answer, study.search->outcome);
      if (verdict)
        values.learn(scene, *verdict);
      else
        open.push_back(scene);
      search.tell(key, verdict ? *verdict : values.verdict_of(scene));
    }
    if (!open.empty()) rounds.push_back(std::move(open));
  }
  return rounds;
}

int count(const Rounds& rounds) {
  int runs = 0;
  for (const auto& round : rounds) runs += static_cast<int>(round.size());
  return runs;
}

}  // namespace

SearchForecast forecast_search(const Study& study, const Answers* known) {
  SearchForecast forecast;
  forecast.rounds = play(study, known, 0.5);
  forecast.runs = forecast.fewest = forecast.most = count(forecast.rounds);
  for (const double place : {0.05, 0.2, 0.35, 0.65, 0.8, 0.95}) {
    const int runs = count(play(study, known, place));
    forecast.fewest = std::min(forecast.fewest, runs);
    forecast.most = std::max(forecast.most, runs);
  }
  return forecast;
}

}  // namespace mpmstudy
