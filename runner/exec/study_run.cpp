#include "runner/exec/study_run.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "runner/ladder/ladder_planner.hpp"
#include "runner/surface/surface_planner.hpp"

namespace mpmstudy {
namespace {

/// Of a search only what is chosen: which of its possible jobs are its own is for the search to say. Of a
/// ladder, the finer cells that are chosen, too.
std::vector<Job> jobs_to_register(const PlannedStudy& study) {
  if (study.selection.members == Members::also) return jobs_to_run(study);
  auto jobs = first_jobs(study.plan);
  if (!study.selection.keys) return jobs;
  std::unordered_set<std::string> known;
  for (const Job& job : jobs) known.insert(job.key);
  for (Job& job : jobs_to_run(study))
    if (!known.contains(job.key)) jobs.push_back(std::move(job));
  return jobs;
}

std::unique_ptr<Planner> planner_of(const PlannedStudy& study) {
  if (study.search) return std::make_unique<SearchPlanner>(*study.search, study.plan.cost);
  if (study.surface && !study.selection.keys)
    return std::make_unique<SurfacePlanner>(*study.surface, study.plan);
  if (study.plan.ladder.accuracy && !study.selection.keys)  // jobs that are chosen run without a reason
    return std::make_unique<LadderPlanner>(study.plan);
  return std::make_unique<Sweep>(jobs_to_register(study));
}

/// Until it has no more to ask for, or waits.
std::vector<Job> ask(Planner& planner, const Answers& answers) {
  std::vector<Job> wanted;
  for (auto more = planner.next(answers); !more.empty(); more = planner.next(answers))
    std::ranges::move(more, std::back_inserter(wanted));
  return wanted;
}

}  // namespace

std::vector<Job> jobs_to_run(const PlannedStudy& study) {
  if (!study.selection.keys) return first_jobs(study.plan);
  auto jobs = all_jobs(study.plan);
  std::erase_if(jobs, [&](const Job& job) { return !study.selection.has(job.key); });
  return jobs;
}

std::vector<Job> jobs_wanted(const PlannedStudy& study, const Answers& answers) {
  auto jobs = ask(*planner_of(study), answers);
  std::erase_if(jobs, [&](const Job& job) { return !study.selection.has(job.key) || answers.of(job.key); });
  return jobs;
}

std::optional<Answer> RunAnswers::of(const std::string& key) const {
  auto answer = known_.of(key);
  if (answer && !answer->done && retries(key)) answer.reset();
  return answer;
}

StudyRun::StudyRun(const PlannedStudy& study)
    : study_(study),
      planner_(planner_of(study_)),
      search_(dynamic_cast<const SearchPlanner*>(planner_.get())) {}

Entered StudyRun::advance(const RunAnswers& answers, CatalogWriter& writer) {
  std::vector<Job> wanted = ask(*planner_, answers);
  const auto finer = std::ranges::stable_partition(wanted, [](const Job& job) { return !job.finer; });
  Entered entered;
  if (const auto first_finer = finer.begin(); !registered_ || first_finer != wanted.begin()) {
    Selection selection = study_.selection;
    if (std::exchange(registered_, true)) selection.members = Members::also;
    selection.retry.emplace();
    bool retry = false;
    for (auto job = wanted.begin(); job != first_finer; ++job)
      if (answers.retries(job->key)) retry = true, selection.retry->insert(job->key);
    const Registration registration = writer.register_study(
        study_.plan.study, study_.title, {wanted.begin(), first_finer}, retry, study_.source, selection);
    entered.states = registration.states;
    entered.taken_up = registration.taken_up;
    entered.damaged = registration.damaged;
  }
  for (const Job& job : finer)
    entered.states.push_back(writer.add_finer(study_.plan.study, job, answers.retries(job.key)));
  entered.jobs = std::move(wanted);
  return entered;
}

}  // namespace mpmstudy
