#include "runner/search/search_planner.hpp"

#include <fmt/format.h>

#include <utility>

#include "runner/study/searched.hpp"

namespace mpmstudy {
namespace {

bool stops_early(const mpm::Scene& scene) { return scene.measures.stop == mpm::Stop::decided; }

mpm::Scene to_its_end(mpm::Scene scene) {
  scene.measures.stop = mpm::Stop::end_time;
  return scene;
}

bool sampled(const std::string& key, double share) {
  return static_cast<double>(std::stoul(key.substr(0, 8), nullptr, 16)) < share * 4294967296.0;
}

}  // namespace

Verdict verdict_of(const Answer& answer, const std::string& outcome) {
  if (!answer.done) return Verdict::broken;
  if (answer.outcome == outcome) return Verdict::above;
  return answer.outcome == "undecided" ? Verdict::undecided : Verdict::below;
}

SearchPlanner::SearchPlanner(const Study& study, CostModel cost)
    : outcome_(study.search->outcome), cost_(std::move(cost)), search_(study) {}

std::vector<Job> SearchPlanner::next(const Answers& answers) {
  std::vector<std::pair<Verdict, double>> verdicts;
  for (std::size_t i = told_; i < jobs_.size(); ++i) {
    const auto answer = answers.of(jobs_[i].key);
    if (!answer) return {};
    verdicts.emplace_back(verdict_of(*answer, outcome_), answer->margin);
  }
  for (const auto& [verdict, margin] : verdicts) search_.tell(jobs_[told_++].key, verdict, margin);
  const auto round = search_.next_round();
  ended_ = round.empty();
  if (!ended_) ++round_;
  std::vector<Job> wanted;
  for (const auto& [scene, why] : round)
    wanted.push_back(make_job(scene, cost_, fmt::format("round {} of the search: {}", round_, why)));
  jobs_.insert(jobs_.end(), wanted.begin(), wanted.end());
  return wanted;
}

AuditSample audit_sample(const std::vector<Job>& jobs, double share, const CostModel& cost,
                         const Answers& answers) {
  AuditSample sample;
  for (const Job& job : jobs) {
    if (!stops_early(job.scene)) continue;
    const auto answer = answers.of(job.key);
    if (!answer || !answer->done) continue;  // a run that broke down said nothing
    ++sample.early;
    if (!sampled(job.key, share)) continue;
    std::string why = "an audit: does " + job.key + ", which stopped when decided, say what its end says?";
    sample.runs.push_back({job.key, make_job(to_its_end(job.scene), cost, std::move(why))});
  }
  return sample;
}

std::vector<mpm::Scene> possible_scenes(const Study& study,
                                        const std::function<bool(const std::string& key)>& wanted) {
  const SearchRequest& request = *study.search;
  SearchValues values(request.lower, request.upper, request.tolerance);
  values.intervals *= 2;  // half steps: where runs failed
  const Searched critical(study);
  std::vector<mpm::Scene> scenes;
  const auto add = [&](const mpm::Scene& scene) {
    if (wanted(job_key(scene))) scenes.push_back(scene);
  };
  for (mpm::Scene scene : study.scenes)
    for (int i = 0; i <= values.intervals; ++i) {
      critical.set(scene, values.value(i));
      add(scene);
      if (stops_early(scene)) add(to_its_end(scene));
    }
  return scenes;
}

}  // namespace mpmstudy
