#include "runner/plan/plan.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_set>

#include "runner/study/ladder.hpp"

namespace mpmstudy {
namespace {

constexpr const char* of_the_sweep = "a point of the sweep";

/// The rungs of one scene, coarse to fine.
std::vector<Job> make_ladder(const mpm::Scene& scene, const LadderRequest& request, std::int64_t position,
                             const CostModel& cost) {
  const LadderScenes ladder = ladder_scenes(scene, request);
  std::vector<Job> rungs;
  for (const mpm::Scene& rung : ladder.scenes) rungs.push_back(make_job(rung, cost, of_the_sweep));
  for (std::size_t k = 0; k < ladder.first_answer; ++k) {
    rungs[k].rung_of = position;
    rungs[k].reason = "a coarser cell, for the interval";
  }
  return rungs;
}

/// Adds what is not there yet.
class UniqueJobs {
 public:
  void add(const Job& job) {
    if (known_.insert(job.key).second) jobs.push_back(job);
  }
  std::vector<Job> jobs;

 private:
  std::unordered_set<std::string> known_;
};

}  // namespace

Job make_job(const mpm::Scene& scene, const CostModel& cost, std::string reason) {
  const mpm::Estimate estimate = mpm::estimate(scene);
  return {job_key(scene), scene, estimate, cost.seconds(estimate), {}, false, std::move(reason)};
}

LadderScenes ladder_scenes(const mpm::Scene& scene, const LadderRequest& request) {
  LadderScenes ladder;
  const int first_answer = request.accuracy ? first_cells - 1 : request.cells - 1;
  for (int k = 0; k < request.cells; ++k) {
    mpm::Scene rung = scene;
    rung.numerics.cell_size =
        finer_cell(scene.numerics.cell_size, request.finds_cell ? k : k + 1 - request.cells);
    if (k < first_answer) rung.measures.snapshots.clear();
    ladder.scenes.push_back(std::move(rung));
  }
  ladder.first_answer = static_cast<std::size_t>(first_answer);
  return ladder;
}

Plan make_plan(const Study& study, const CostModel& cost) {
  Plan plan;
  plan.study = study.name;
  plan.ladder = study.ladder;
  plan.cost = cost;
  std::unordered_set<std::string> known;
  for (const mpm::Scene& scene : study.scenes) {
    if (study.ladder.cells == 1) {  // at the cell that is given or found
      Job job = make_job(scene, cost, of_the_sweep);
      if (known.insert(job.key).second) plan.jobs.push_back(std::move(job));
      continue;
    }
    auto rungs = make_ladder(scene, study.ladder, static_cast<std::int64_t>(plan.jobs.size()), cost);
    const Job& answer = study.ladder.accuracy ? rungs[first_cells - 1] : rungs.back();
    if (!known.insert(answer.key).second) continue;
    plan.jobs.push_back(answer);
    plan.ladders.push_back(std::move(rungs));
  }
  if (study.surface)
    for (const mpm::Scene& scene : study.surface->candidates) {
      Job job = make_job(scene, cost);
      if (known.insert(job.key).second) plan.candidates.push_back(std::move(job));
    }
  return plan;
}

std::vector<Job> first_jobs(const Plan& plan) {
  UniqueJobs unique;
  for (const Job& job : plan.jobs) unique.add(job);
  for (const auto& rungs : plan.ladders)
    for (const Job& rung : rungs)
      if (rung.rung_of) unique.add(rung);
  return std::move(unique.jobs);
}

std::vector<Job> all_jobs(const Plan& plan) {
  UniqueJobs unique;
  for (const Job& job : first_jobs(plan)) unique.add(job);
  for (const auto& rungs : plan.ladders)
    for (const Job& rung : rungs) unique.add(rung);
  for (const Job& job : plan.candidates) unique.add(job);
  return std::move(unique.jobs);
}

double cpu_seconds(const std::vector<Job>& jobs) {
  double sum = 0;
  for (const Job& job : jobs) sum += job.predicted_seconds;
  return sum;
}

Prediction total_cost(const CostModel& cost, const std::vector<Job>& jobs) {
  std::vector<mpm::Estimate> estimates;
  for (const Job& job : jobs) estimates.push_back(job.estimate);
  return cost.total(estimates);
}

double wall_seconds(const std::vector<Job>& jobs, int workers) {
  std::vector<double> costs;
  for (const Job& job : jobs) costs.push_back(job.predicted_seconds);
  std::sort(costs.begin(), costs.end(), std::greater<>());
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (int worker = 0; worker < std::max(workers, 1); ++worker) free_at.push(0);
  double last = 0;
  for (const double cost : costs) {
    const double end = free_at.top() + cost;
    free_at.pop();
    free_at.push(end);
    last = std::max(last, end);
  }
  return last;
}

}  // namespace mpmstudy
