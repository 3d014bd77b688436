#include "runner/cli/run_intent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "runner/catalog/answers.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/job_states.hpp"
#include "runner/cli/amounts.hpp"
#include "runner/cli/ask.hpp"
#include "runner/cli/print_search.hpp"
#include "runner/exec/processors.hpp"
#include "runner/plan/warnings.hpp"
#include "runner/search/forecast.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {
namespace {

/// The jobs that a run begins with, and what a [surface] has added to them or adds next.
std::vector<Job> jobs_known(const PlannedStudy& study, const RunAnswers& answers) {
  auto jobs = jobs_to_run(study);
  if (study.surface && !study.selection.keys)
    for (Job& job : jobs_wanted(study, answers)) jobs.push_back(std::move(job));
  return jobs;
}

/// What a [surface] may do beside the jobs that are listed.
std::string surface_text(const Study& study) {
  if (!study.surface) return "";
  return fmt::format("{}: [surface] adds runs, {} in a round, until {} in all or its tolerance holds\n",
                     study.name, study.surface->batch, study.surface->budget);
}

}  // namespace

int print_intent(const RunOptions& options, const std::vector<Study>& studies,
                 const std::vector<PlannedStudy>& planned, const CostModel& cost, const JobLabels& labels) {
  const auto known = job_states(options.results);
  std::vector<Job> jobs;
  std::map<JobStatus, std::int64_t> kept;
  std::set<std::string> seen;
  double seconds = 0;
  const CatalogAnswers known_answers(options.results);
  const RunAnswers answers(known_answers, options.retry_failed);
  for (const auto& study : planned)
    for (const auto& job : jobs_known(study, answers)) {
      if (!seen.insert(job.key).second) continue;
      const auto found = known.find(job.key);
      const JobStatus status = found == known.end() ? JobStatus::planned : found->second;
      if (status == JobStatus::done || (status == JobStatus::failed && !options.retry_failed)) {
        ++kept[status];
        continue;
      }
      jobs.push_back(job);
      seconds += job.predicted_seconds;
    }
  std::ranges::stable_sort(jobs, std::ranges::greater{}, &Job::predicted_seconds);
  for (const auto& job : jobs)
    fmt::print("{}\n", cut_text(fmt::format("{}  {} particles, {} steps, {}  {}", short_key(job.key),
                                            job.estimate.particles, job.estimate.steps,
                                            readable_duration(job.predicted_seconds), labels(job)),
                                line_columns));
  auto count = static_cast<std::int64_t>(jobs.size());
  bool about = false;
  for (const auto& study : studies) {
    if (!study.search || !options.only.empty()) continue;
    const SearchForecast forecast = forecast_search(study, &answers);
    fmt::print("{}: {}\n", study.name, readable_forecast(study, forecast));
    for (const auto& round : forecast.rounds)
      for (const auto& scene : round) seconds += cost.seconds(mpm::estimate(scene));
    count += forecast.runs;
    about |= forecast.runs > 0;
  }
  for (const auto& study : studies) fmt::print("{}", surface_text(study));
  fmt::print("{}{} would run, about {} of one core; {} done already{}\n", about ? "about " : "",
             counted(count, "job"), readable_duration(seconds), kept[JobStatus::done],
             kept[JobStatus::failed] > 0
                 ? fmt::format(", {} failed before: only --retry-failed runs {} again",
                               kept[JobStatus::failed], kept[JobStatus::failed] == 1 ? "it" : "them")
                 : "");
  return exit_ok;
}

void warn_and_ask(const RunOptions& options, const std::vector<Study>& studies,
                  const std::vector<PlannedStudy>& planned, const CostModel& cost) {
  std::map<std::string, JobStatus> known;
  try {
    known = job_states(options.results);
  } catch (const CatalogError&) {  // of an older program, or damaged: opening it to write sees to that
  }
  const auto done = [&](const std::string& key) {
    const auto found = known.find(key);
    return found != known.end() && found->second == JobStatus::done;
  };
  std::vector<Job> left;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < studies.size(); ++i) {
    const Study& study = studies[i];
    const Plan plan = study.search ? make_plan(study, cost) : planned[i].plan;
    print_warnings(warnings_of(study, plan));
    for (const Job& job : first_jobs(plan))
      if (!done(job.key) && !done(former_key(job.scene)) && seen.insert(job.key).second) left.push_back(job);
  }
  if (options.study.yes || options.dry_run || left.empty()) return;
  if (options.engine ==
      "slurm") {  // memory and processors are another machine's; the longest job takes its time
    const double longest = std::ranges::max_element(left, {}, &Job::predicted_seconds)->predicted_seconds;
    ask(too_much({0, longest}, std::nullopt));
    return;
  }
  ask(too_much(demand_of(left, options.workers > 0 ? options.workers : usable_processors()), free_memory()));
}

}  // namespace mpmstudy
