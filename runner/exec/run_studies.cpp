#include "runner/exec/run_studies.hpp"

#include <csignal>
#include <thread>
#include <unordered_set>

#include "runner/catalog/connection.hpp"

namespace mpmstudy {
namespace {

/// Registers every study; gives back the jobs to run, each key once.
std::vector<Job> register_all(std::span<const PlannedStudy> studies, bool retry_failed, CatalogWriter& writer,
                              RunReport& report, RunStart& start) {
  std::vector<Job> to_run;
  std::unordered_set<std::string> seen;
  for (const auto& study : studies) {
    const auto& jobs = study.plan.jobs;
    const auto registered = writer.register_study(study.plan.study, study.title, jobs, retry_failed);
    start.taken_up += registered.taken_up;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!seen.insert(jobs[i].key).second) continue;
      switch (registered.states[i]) {
        case JobStatus::done:
          ++report.reused;
          break;
        case JobStatus::failed:
          ++report.left_failed;
          break;
        case JobStatus::running:
          ++report.elsewhere;
          break;
        default:
          to_run.push_back(jobs[i]);
          start.predicted_seconds += jobs[i].predicted_seconds;
      }
    }
  }
  return to_run;
}

std::string stop_reason(const RunReport& report) {
  if (!report.executed.storage_error.empty()) return report.executed.storage_error;
  if (report.left() == 0) return {};
  if (report.signal == SIGINT) return "interrupted";
  if (report.signal != 0) return "asked to end by signal " + std::to_string(report.signal);
  return "another process runs the jobs that are left";
}

}  // namespace

int RunReport::exit_code() const {
  if (left() > 0) return signal == SIGINT ? 130 : 75;
  return executed.failed + left_failed > 0 ? 1 : 0;
}

RunReport run_studies(std::span<const PlannedStudy> studies, bool retry_failed, CatalogWriter& writer,
                      Status& status, const Simulate& simulate, const WriteSnapshot& write, StopFlag& flag,
                      const ExecutorOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  RunReport report;
  RunStart start;
  auto jobs = register_all(studies, retry_failed, writer, report, start);
  start.jobs = static_cast<std::int64_t>(jobs.size());
  start.reused = report.reused;
  start.left_failed = report.left_failed;
  start.workers = worker_count(options, jobs.size());
  status.run_started(start);

  report.executed = execute_jobs(std::move(jobs), simulate, write, writer, status, flag, options);
  report.signal = flag.signal();

  RunEnd end;
  end.done = report.executed.done;
  end.failed = report.executed.failed + report.left_failed;
  end.reused = report.reused;
  end.left = report.left();
  end.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (report.executed.cpu_s > 0) end.updates_per_second = report.executed.updates / report.executed.cpu_s;
  end.catalog = catalog_path(options.results).string();
  end.stop_reason = stop_reason(report);
  status.run_finished(end);
  return report;
}

}  // namespace mpmstudy
