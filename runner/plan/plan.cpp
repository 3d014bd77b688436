#include "runner/plan/plan.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_set>

namespace mpmstudy {

Plan make_plan(const Study& study, double updates_per_second) {
  Plan plan;
  plan.study = study.name;
  std::unordered_set<std::string> known;
  for (const mpm::Scene& scene : study.scenes) {
    std::string key = job_key(scene);
    if (!known.insert(key).second) continue;
    const mpm::Estimate estimate = mpm::estimate(scene);
    const double updates = static_cast<double>(estimate.particles) * static_cast<double>(estimate.steps);
    plan.jobs.push_back({std::move(key), scene, estimate, updates / updates_per_second});
  }
  return plan;
}

double cpu_seconds(const Plan& plan) {
  double sum = 0;
  for (const Job& job : plan.jobs) sum += job.predicted_seconds;
  return sum;
}

double wall_seconds(const Plan& plan, int workers) {
  std::vector<double> costs;
  for (const Job& job : plan.jobs) costs.push_back(job.predicted_seconds);
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
