#include "runner/exec/run_studies.hpp"

#include <algorithm>
#include <csignal>
#include <functional>
#include <thread>
#include <unordered_set>

#include "runner/ladder/climbs.hpp"

namespace mpmstudy {
namespace {

/// Of a search only what is chosen: which of its possible jobs are its own is for the search to say. Of a
/// ladder, the finer cells that are chosen, too.
std::vector<Job> jobs_to_register(const PlannedStudy& study) {
  if (study.selection.members == Members::also) return jobs_to_run(study);
  auto jobs = first_jobs(study.plan);
  if (!study.selection.keys) return jobs;
  std::unordered_set<std::string> known;
  for (const auto& job : jobs) known.insert(job.key);
  for (auto& job : jobs_to_run(study))
    if (!known.contains(job.key)) jobs.push_back(std::move(job));
  return jobs;
}

/// Registers every study; gives back the jobs to run, each key once.
std::vector<Job> register_all(std::span<const PlannedStudy> studies, bool retry_failed, CatalogWriter& writer,
                              RunReport& report, RunStart& start) {
  std::vector<Job> to_run;
  std::unordered_set<std::string> seen;
  for (const auto& study : studies) {
    const auto jobs = jobs_to_register(study);
    const auto registered = writer.register_study(study.plan.study, study.title, jobs, retry_failed,
                                                  study.source, study.selection);
    start.taken_up += registered.taken_up;
    start.damaged += registered.damaged;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!study.selection.has(jobs[i].key) || !seen.insert(jobs[i].key).second) continue;
      switch (registered.states[i]) {
        case JobStatus::done:
          ++report.reused;
          break;
        case JobStatus::failed:
          ++report.left_failed;
          break;
        default:  // running by another process: until that one is done with it, or gone
          to_run.push_back(jobs[i]);
          start.predicted_seconds += jobs[i].predicted_seconds;
      }
    }
  }
  return to_run;
}

ExecutorReport sum_of(ExecutorReport sum, const ExecutorReport& more) {
  sum.done += more.done;
  sum.failed += more.failed;
  sum.stopped += more.stopped;
  sum.untouched += more.untouched;
  sum.done_elsewhere += more.done_elsewhere;
  sum.failed_elsewhere += more.failed_elsewhere;
  sum.updates += more.updates;
  sum.cpu_s += more.cpu_s;
  sum.predicted_s += more.predicted_s;
  sum.budget_spent = sum.budget_spent || more.budget_spent;
  if (sum.storage_error.empty()) sum.storage_error = more.storage_error;
  return sum;
}

/// Finer cells under the jobs that an accuracy was asked of, a round of all ladders at a time.
void climb_ladders(std::span<const PlannedStudy> studies, bool retry_failed, CatalogWriter& writer,
                   Status& status, RunReport& report,
                   const std::function<ExecutorReport(std::vector<Job>)>& execute,
                   const std::filesystem::path& results) {
  Climbs climbs(writer, results, retry_failed);
  for (const auto& study : studies)
    if (!study.selection.keys) climbs.add(study.plan);  // who chooses jobs knows what they are for
  while (report.left() == 0) {
    auto jobs = climbs.next();
    if (jobs.empty()) break;
    status.jobs_added(static_cast<std::int64_t>(jobs.size()), cpu_seconds(jobs));
    report.executed = sum_of(report.executed, execute(std::move(jobs)));
  }
  report.reused += climbs.reused();
  report.left_failed += climbs.left_failed();
}

/// How far off the prediction for these studies may be: of several, the one that is worst known.
double predicted_factor(std::span<const PlannedStudy> studies) {
  double factor = 1;
  for (const auto& study : studies)
    if (const auto cost = total_cost(study.plan.cost, jobs_to_run(study)); cost.interval)
      factor = std::max(factor, cost.interval->high / cost.seconds);
  return factor;
}

std::string stop_reason(const RunReport& report) {
  if (!report.executed.storage_error.empty()) return report.executed.storage_error;
  if (report.left() == 0) return {};
  if (report.executed.budget_spent) return "the budget is spent";
  if (report.signal == SIGINT) return "interrupted";
  if (report.signal != 0) return "asked to end by " + signal_name(report.signal);
  return "another run has changed the study";
}

RunEnd end_of(const RunReport& report, double predicted_factor, std::chrono::steady_clock::time_point begin) {
  const ExecutorReport& executed = report.executed;
  RunEnd end;
  end.done = executed.done + executed.done_elsewhere;
  end.failed = executed.failed + executed.failed_elsewhere + report.left_failed;
  end.reused = report.reused;
  end.left = report.left();
  end.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (executed.cpu_s > 0) end.updates_per_second = executed.updates / executed.cpu_s;
  end.predicted_s = executed.predicted_s;
  end.predicted_factor = predicted_factor;
  end.cpu_s = executed.cpu_s;
  end.stop_reason = stop_reason(report);
  return end;
}

}  // namespace

RunReport& RunReport::operator+=(const RunReport& next) {
  executed = sum_of(std::move(executed), next.executed);
  reused += next.reused;
  left_failed += next.left_failed;
  signal = next.signal != 0 ? next.signal : signal;
  return *this;
}

std::vector<Job> jobs_to_run(const PlannedStudy& study) {
  if (!study.selection.keys) return first_jobs(study.plan);
  auto jobs = all_jobs(study.plan);
  std::erase_if(jobs, [&](const Job& job) { return !study.selection.has(job.key); });
  return jobs;
}

int RunReport::exit_code() const {
  if (left() > 0) return signal == SIGINT ? 130 : 75;
  return executed.failed + executed.failed_elsewhere + left_failed > 0 ? 1 : 0;
}

RunReport run_studies(std::span<const PlannedStudy> studies, bool retry_failed, CatalogWriter& writer,
                      Status& status, const Simulate& simulate, const WriteSnapshot& write, StopFlag& flag,
                      const ExecutorOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  RunReport report;
  RunStart start;
  auto jobs = register_all(studies, retry_failed, writer, report, start);
  writer.sweep_files();
  if (studies.size() == 1) start.study = studies[0].plan.study;
  start.jobs = static_cast<std::int64_t>(jobs.size());
  start.reused = report.reused;
  start.left_failed = report.left_failed;
  start.workers = worker_count(options, jobs.size());
  start.predicted_factor = predicted_factor(studies);
  status.run_started(start);

  ExecutorOptions with_end = options;
  if (options.abandon)
    with_end.abandon = [&](const ExecutorReport& executed) {
      report.executed = sum_of(report.executed, executed);
      report.signal = flag.signal();
      status.run_finished(end_of(report, start.predicted_factor, begin));
      options.abandon(executed);
    };
  const auto execute = [&](std::vector<Job> some) {
    return execute_jobs(std::move(some), simulate, write, writer, status, flag, with_end);
  };
  report.executed = execute(std::move(jobs));
  climb_ladders(studies, retry_failed, writer, status, report, execute, options.results);
  report.signal = flag.signal();
  status.run_finished(end_of(report, start.predicted_factor, begin));
  return report;
}

}  // namespace mpmstudy
