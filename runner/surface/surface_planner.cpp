#include "runner/surface/surface_planner.hpp"

#include <fmt/format.h>

#include <unordered_set>
#include <utility>

#include "analysis/next_places.hpp"
#include "libmpm/measure/results.hpp"
#include "runner/surface/surface_state.hpp"

namespace mpmstudy {
namespace {

/// What a decided job says to a surface.
SurfaceRun run_of(const Job& job, const std::string& of, const Answers& answers) {
  SurfaceRun run{&job.scene, {}, 0};
  const mpm::ResultRow* row = mpm::find_result(of);
  if (row && row->of_closed_cavity && !answers.flags(job.key).empty()) return run;
  if (const auto reading = answers.reading(job.key, of)) {
    run.value = reading->value;
    run.error = reading->error;
  }
  return run;
}

}  // namespace

SurfacePlanner::SurfacePlanner(const Study& study, const Plan& plan)
    : study_(study), candidates_(plan.candidates), jobs_(first_jobs(plan)) {}

std::vector<Job> SurfacePlanner::next(const Answers& answers) {
  if (!std::exchange(begun_, true)) return jobs_;
  if (ended_) return {};
  std::vector<SurfaceRun> runs;
  std::vector<const mpm::Scene*> silent;
  std::unordered_set<std::string> asked;
  for (const Job& job : jobs_) {
    if (!answers.of(job.key)) return {};
    runs.push_back(run_of(job, study_.surface->of, answers));
    if (!runs.back().value) silent.push_back(&job.scene);
    asked.insert(job.key);
  }
  const SurfaceRequest& request = *study_.surface;
  const std::int64_t left = request.budget - std::ssize(jobs_);
  const SurfaceState state = surface_state(study_, runs);
  ended_ = state.holds() || !state.failure.empty() || left <= 0;
  if (ended_) return {};
  std::vector<const Job*> candidates;
  std::vector<const mpm::Scene*> scenes;
  for (const Job& job : candidates_)
    if (!asked.contains(job.key)) candidates.push_back(&job), scenes.push_back(&job.scene);
  ++round_;
  const std::string why = fmt::format("round {} of the surface, where a run tells it most: {}", round_,
                                      readable_state(study_, state));
  std::vector<Job> wanted;
  for (const Eigen::Index place :
       analysis::next_places(*state.process, places_of(study_, scenes), places_of(study_, silent),
                             static_cast<std::size_t>(std::min(request.batch, left)))) {
    wanted.push_back(*candidates[static_cast<std::size_t>(place)]);
    wanted.back().reason = why;
  }
  jobs_.insert(jobs_.end(), wanted.begin(), wanted.end());
  ended_ = wanted.empty();
  return wanted;
}

}  // namespace mpmstudy
