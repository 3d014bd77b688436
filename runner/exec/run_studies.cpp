#include "runner/exec/run_studies.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>
#include <iterator>
#include <unordered_set>

#include "runner/catalog/answers.hpp"
#include "runner/search/bracket_rows.hpp"

namespace mpmstudy {
namespace {

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

/// How far off the prediction for these jobs may be.
double predicted_factor(const CostModel& cost, const std::vector<Job>& jobs) {
  if (jobs.empty()) return 1;
  const auto total = total_cost(cost, jobs);
  return total.interval ? total.interval->high / total.seconds : 1;
}

std::string stop_reason(const RunReport& report) {
  if (!report.executed.storage_error.empty()) return report.executed.storage_error;
  if (report.left() == 0) return {};
  if (report.executed.budget_spent) return "the budget is spent";
  if (report.signal == SIGINT) return "interrupted";
  if (report.signal != 0) return "asked to end by " + signal_name(report.signal);
  return "another run has changed the study";
}

/// The audit of a search that has ended: what was sampled, and its study.
struct AuditRun {
  std::string search, outcome;  ///< name, what it looks for
  std::vector<AuditedRun> runs;
};

class Engine {
 public:
  Engine(std::span<const PlannedStudy> studies, CatalogWriter& writer, Workers& workers, Status& status,
         StopFlag& flag, const EngineOptions& options)
      : writer_(writer),
        workers_(workers),
        status_(status),
        flag_(flag),
        options_(options),
        known_(options.results),
        answers_(known_, options.retry_failed) {
    for (const PlannedStudy& study : studies) add(study, runs_.size());
    if (studies.size() == 1) start_.study = studies[0].plan.study;
  }

  RunReport run() {
    // Planners go on at once where all that they want is decided already.
    for (bool wanted = true; wanted && report_.left() == 0;) {
      std::vector<Job> to_run;
      wanted = ask_all(to_run);
      if (!started_) start(to_run);
      if (to_run.empty()) continue;
      report_.signal = flag_.signal();
      if (report_.signal != 0)
        report_.executed.untouched += std::ssize(to_run);
      else
        execute(std::move(to_run));
    }
    // A search that waits though all that it asked for was run: another run has taken its jobs away.
    if (report_.left() == 0)
      for (const StudyRun& run : runs_)
        if (run.search()) report_.executed.untouched += run.search()->waits_for();
    if (report_.left() == 0) close_audits();
    report_.signal = flag_.signal();
    status_.run_finished(end());
    return std::move(report_);
  }

 private:
  void add(const PlannedStudy& study, std::size_t place) {
    runs_.emplace_back(study);
    places_.push_back(place);
  }

  /// False if no study wants any more.
  bool ask_all(std::vector<Job>& to_run) {
    bool any = false;
    for (std::size_t i = 0; i < runs_.size(); ++i) {  // audits are added on the way
      any |= ask(i, to_run);
      const SearchPlanner* search = runs_[i].search();
      const std::string& name = runs_[i].study().plan.study;
      if (search && search->ended() && !report_.searches.contains(name)) any |= close(runs_[i], places_[i]);
    }
    if (started_ && !to_run.empty()) status_.jobs_added(std::ssize(to_run), cpu_seconds(to_run));
    return any;
  }

  bool ask(std::size_t place, std::vector<Job>& to_run) {
    StudyRun& run = runs_[place];
    const Entered entered = run.advance(answers_, writer_);
    if (options_.on_wanted) options_.on_wanted(places_[place], entered.jobs);
    start_.taken_up += entered.taken_up;
    start_.damaged += entered.damaged;
    std::vector<Job> own;
    for (std::size_t i = 0; i < entered.jobs.size(); ++i) {
      const Job& job = entered.jobs[i];
      if (!run.study().selection.has(job.key) || !seen_.insert(job.key).second) continue;
      switch (entered.states[i]) {
        case JobStatus::done:
          ++report_.reused;
          break;
        case JobStatus::failed:
          ++report_.left_failed;
          break;
        default:  // running by another process: until that one is done with it, or gone
          own.push_back(job);
      }
    }
    if (!started_)
      start_.predicted_factor =
          std::max(start_.predicted_factor, predicted_factor(run.study().plan.cost, own));
    std::ranges::move(own, std::back_inserter(to_run));
    return !entered.jobs.empty();
  }

  /// A search has ended: its brackets, and what its audit runs. True if that is anything.
  bool close(const StudyRun& run, std::size_t place) {
    const SearchPlanner& search = *run.search();
    const PlannedStudy& study = run.study();
    SearchReport& report = report_.searches[study.plan.study];
    report.brackets = search.brackets();
    writer_.replace_brackets(study.plan.study, bracket_rows(*study.search, report.brackets));
    if (!(study.audit > 0)) return false;
    AuditSample sample = audit_sample(search.jobs(), study.audit, study.plan.cost, answers_);
    report.audit.early = sample.early;
    if (sample.runs.empty()) return false;
    PlannedStudy& whole =
        audited_.emplace_back(PlannedStudy{{study.plan.study + "-audit", {}, {}, {}, study.plan.cost},
                                           study.title + ", runs that stopped early run to their end",
                                           study.source});
    for (const AuditedRun& one : sample.runs) whole.plan.jobs.push_back(one.whole);
    audits_.push_back({study.plan.study, study.search->search->outcome, std::move(sample.runs)});
    add(whole, place);
    return true;
  }

  void close_audits() {
    for (const AuditRun& audit : audits_) {
      Audit& found = report_.searches[audit.search].audit;
      for (const auto& [early, whole] : audit.runs) {
        const auto said = known_.of(early), says = known_.of(whole.key);
        if (!said || !says) continue;  // another run has taken them away
        ++found.audited;
        if ((said->outcome == audit.outcome) != (says->outcome == audit.outcome))
          found.disagreeing.push_back(early);
      }
    }
  }

  void start(const std::vector<Job>& to_run) {
    started_ = true;
    writer_.sweep_files();
    start_.jobs = std::ssize(to_run);
    start_.predicted_seconds = cpu_seconds(to_run);
    start_.reused = report_.reused;
    start_.left_failed = report_.left_failed;
    start_.workers = workers_.count(to_run.size());
    status_.run_started(start_);
  }

  void execute(std::vector<Job> to_run) {
    for (const Job& job : to_run) answers_.tried(job.key);
    const ExecutorReport before = report_.executed;
    report_.executed = sum_of(before, workers_.run(std::move(to_run), [&](const ExecutorReport& executed) {
      report_.executed = sum_of(before, executed);
      report_.signal = flag_.signal();
      status_.run_finished(end());
    }));
  }

  RunEnd end() const {
    const ExecutorReport& executed = report_.executed;
    RunEnd end;
    end.done = executed.done + executed.done_elsewhere;
    end.failed = executed.failed + executed.failed_elsewhere + report_.left_failed;
    end.reused = report_.reused;
    end.left = report_.left();
    end.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    if (executed.cpu_s > 0) end.updates_per_second = executed.updates / executed.cpu_s;
    end.predicted_s = executed.predicted_s;
    end.predicted_factor = start_.predicted_factor;
    end.cpu_s = executed.cpu_s;
    end.stop_reason = stop_reason(report_);
    return end;
  }

  CatalogWriter& writer_;
  Workers& workers_;
  Status& status_;
  StopFlag& flag_;
  const EngineOptions& options_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  CatalogAnswers known_;
  RunAnswers answers_;
  std::deque<PlannedStudy> audited_;  ///< the studies of audits
  std::deque<StudyRun> runs_;         ///< those given, then audits
  std::vector<std::size_t> places_;   ///< of each: of the study that was given, or whose search it audits
  std::vector<AuditRun> audits_;
  std::unordered_set<std::string> seen_;  ///< keys
  RunStart start_;
  RunReport report_;
  bool started_ = false;
};

}  // namespace

std::int64_t SearchReport::not_found() const {
  return std::ranges::count_if(brackets, [](const FoundBracket& b) { return !b.lower; });
}

int RunReport::exit_code() const {
  if (left() > 0) return signal == SIGINT ? 130 : 75;
  const bool found = std::ranges::all_of(searches, [](const auto& s) { return s.second.not_found() == 0; });
  return found && executed.failed + executed.failed_elsewhere + left_failed == 0 ? 0 : 1;
}

RunReport run_studies(std::span<const PlannedStudy> studies, CatalogWriter& writer, Workers& workers,
                      Status& status, StopFlag& flag, const EngineOptions& options) {
  return Engine(studies, writer, workers, status, flag, options).run();
}

RunReport run_studies(std::span<const PlannedStudy> studies, bool retry_failed, CatalogWriter& writer,
                      Status& status, const Simulate& simulate, const WriteSnapshot& write, StopFlag& flag,
                      const ExecutorOptions& options) {
  ThreadWorkers workers(simulate, write, writer, status, flag, options);
  return run_studies(studies, writer, workers, status, flag, {options.results, retry_failed, {}});
}

}  // namespace mpmstudy
