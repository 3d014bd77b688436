#include "runner/cli/run_slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "runner/catalog/answers.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/job_states.hpp"
#include "runner/catalog/timestamp.hpp"
#include "runner/cli/amounts.hpp"
#include "runner/cli/merge.hpp"
#include "runner/cli/print_failures.hpp"
#include "runner/cli/print_results.hpp"
#include "runner/cli/print_search.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/exec/signals.hpp"
#include "runner/slurm/queue.hpp"
#include "runner/slurm/shards.hpp"
#include "runner/slurm/submit.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// "sphere-20310506T070809.123": one folder per submission.
std::string submission_name(const std::string& study) {
  std::string time = utc_now();
  std::erase_if(time, [](char c) { return c == '-' || c == ':' || c == 'Z'; });
  return study + "-" + time;
}

std::vector<std::string> with_flag(const std::string& flag, const std::vector<std::string>& values) {
  std::vector<std::string> words;
  for (const auto& value : values) words.insert(words.end(), {flag, value});
  return words;
}

void append_option(std::vector<std::string>& words, const std::string& flag, const std::string& value) {
  if (!value.empty() && value != "0") words.insert(words.end(), {flag, value});
}

SlurmScripts scripts_for(const RunOptions& options, const Study& study, std::size_t shards, int workers,
                         int round) {
  const fs::path results = fs::absolute(options.results).lexically_normal();
  SlurmScripts s;
  s.study = study.name;
  s.program = fs::read_symlink("/proc/self/exe").string();
  s.results = results.string();
  const std::string name = submission_name(study.name);
  s.folder = (results / "slurm" / name).string();
  // Results folders of one Slurm may submit studies of one name at one moment.
  s.job_name = fmt::format("mpmstudy-{}-{:08x}", name, std::random_device{}());
  s.clusters = clusters_of(options.slurm.options);
  if (s.clusters.empty())
    for (const char* variable : {"SBATCH_CLUSTERS", "SLURM_CLUSTERS"})
      if (const char* value = std::getenv(variable); value != nullptr && s.clusters.empty())
        s.clusters = value;
  s.shards = shards;
  s.workers = workers;
  s.round = round;
  s.run = with_flag("--set", options.study.set);
  if (options.study.cells != 1)
    s.run.insert(s.run.end(), {"--cells", fmt::format("{}", options.study.cells)});
  append_option(s.run, "--timeout", options.timeout);
  append_option(s.run, "--memory", options.memory);
  s.run.insert(s.run.end(), {"--checkpoint", options.checkpoint});
  append_option(s.run, "--retries", std::to_string(options.retries));
  for (const auto& option : options.slurm.options) s.again.push_back("--slurm=" + option);
  append_option(s.again, "--shard-time", options.slurm.shard_time);
  append_option(s.again, "--rounds", std::to_string(options.slurm.rounds));
  append_option(s.again, "--shards", std::to_string(options.slurm.most_shards));
  append_option(s.again, "-j", std::to_string(workers));
  if (study.search) append_option(s.again, "--audit", options.audit);
  s.options = options.slurm.options;
  return s;
}

/// Throws StudyError for what cannot be written into a script.
void check_scripts(const RunOptions& options) {
  for (const auto& option : options.slurm.options)
    if (const auto wrong = wrong_option(option); !wrong.empty())
      throw StudyError("--slurm=" + option + ": " + wrong);
  const std::string results = fs::absolute(options.results).lexically_normal().string();
  if (const auto wrong = wrong_path(results); !wrong.empty())
    throw StudyError("--results " + results + ": " + wrong);
}

void print_shards(const SlurmScripts& scripts, const std::vector<Shard>& shards) {
  std::size_t jobs = 0;
  double longest = 0, sum = 0;
  for (const auto& shard : shards) {
    jobs += shard.jobs.size();
    longest = std::max(longest, shard.seconds);
    sum += shard.seconds;
  }
  fmt::print("{}: {} in {}, about {} of CPU, the longest shard {} on {}\n", scripts.study,
             counted(static_cast<std::int64_t>(jobs), "job"),
             counted(static_cast<std::int64_t>(shards.size()), "shard"), readable_duration(sum),
             readable_duration(longest / scripts.workers), counted(scripts.workers, "processor"));
}

/// The round that this submission is: one that asks for other jobs than the one before is a first one, as of
/// a search or a ladder that goes on; --rounds bounds how often a job is tried.
int round_of(const RunOptions& options, const std::string& study, const std::vector<const Job*>& open) {
  const auto before = last_submitted(options.results, study);
  const bool again = std::ranges::any_of(open, [&](const Job* job) { return before.contains(job->key); });
  return again ? options.slurm.round : 1;
}

/// How the jobs of a study stand, seen from the queue.
struct Standing {
  std::vector<const Job*> to_submit;
  std::size_t queued = 0;
  std::size_t doubtful = 0;   ///< of a submission that may be in the queue
  std::size_t elsewhere = 0;  ///< another `mpmstudy run` is at them
  std::size_t unmerged = 0;   ///< run, but not taken over yet
  std::size_t open() const { return to_submit.size() + queued + doubtful + elsewhere + unmerged; }
};

Standing standing_of(const RunOptions& options, const std::vector<Job>& jobs,
                     const std::vector<Submission>& submissions) {
  std::set<std::string> doubtful, unmerged;
  for (const auto& submission : submissions) {
    if (!submission.unknown.empty()) doubtful.merge(keys_of(submission));
    if (submission.unmerged) unmerged.merge(keys_of(submission));
  }
  const auto queued = queued_keys(submissions);
  // A dry run has not planned failed jobs again, nor those of a process that is gone.
  const auto states = job_states(options.results);
  const auto is = [&](const Job& job, JobStatus status) {
    const auto found = states.find(job.key);
    return found != states.end() && found->second == status;
  };
  const bool tries_again = options.dry_run && options.retry_failed;
  Standing standing;
  for (const auto& job : jobs) {
    if (is(job, JobStatus::done) || (is(job, JobStatus::failed) && !tries_again)) continue;
    if (doubtful.contains(job.key))
      ++standing.doubtful;
    else if (unmerged.contains(job.key))
      ++standing.unmerged;
    else if (queued.contains(job.key))
      ++standing.queued;
    else if (!options.dry_run && is(job, JobStatus::running))
      ++standing.elsewhere;
    else
      standing.to_submit.push_back(&job);
  }
  return standing;
}

/// What is open beside the jobs that are submitted now, and the exit code that it asks for.
int print_standing(const Standing& standing, const Study& study) {
  const auto jobs = [](std::size_t n) { return counted(static_cast<std::int64_t>(n), "job"); };
  if (standing.open() == 0)
    fmt::print("{}: nothing is left to submit: {}\n", study.name,
               study.search || study.ladder.cells > 1
                   ? "these jobs are decided; a run sees what is asked for next"
                   : "every job is decided");
  if (standing.queued > 0)
    fmt::print("{}: {} in the queue already; `mpmstudy status` shows it\n", study.name,
               jobs(standing.queued));
  if (standing.elsewhere > 0)
    fmt::print(stderr, "{}: {} not submitted: another `mpmstudy run` is at work on them\n", study.name,
               jobs(standing.elsewhere));
  if (standing.doubtful > 0)
    fmt::print(stderr, "{}: {} not submitted: they may be in the queue; run again when Slurm answers\n",
               study.name, jobs(standing.doubtful));
  if (standing.unmerged > 0)
    fmt::print(stderr, "{}: {} not submitted: they are in shards that could not be merged now\n", study.name,
               jobs(standing.unmerged));
  return standing.doubtful + standing.elsewhere + standing.unmerged > 0 ? exit_stopped : exit_ok;
}

void print_doubts(const std::vector<Submission>& submissions) {
  for (const auto& s : submissions)
    if (!s.unknown.empty())
      fmt::print(stderr, "{}: not known whether it is in the queue: {}\n", s.folder.string(), s.unknown);
}

/// Sees to the submissions of a study: releases what Slurm holds, asks again for merges that are not in the
/// queue, and takes over the shards of arrays that have ended without one.
int tend(const RunOptions& options, const Study& study, std::vector<Submission>& submissions) {
  int code = exit_ok;
  const Released released = release_stranded(submissions);
  for (const auto& id : released.ids)
    fmt::print("{}: Slurm could not start element {} and held it; it is released\n", study.name, id);
  for (const auto& refusal : released.refusals) {
    fmt::print(stderr, "{}: Slurm holds an element and does not release it: {}\n", study.name, refusal);
    code = exit_stopped;
  }
  for (auto& s : submissions) {
    if (s.record.study != study.name || !s.unknown.empty() || s.merge_queued) continue;
    if (s.array_queued()) {
      std::vector<std::string> notes;
      const std::string trouble = submit_merge(s, notes);
      for (const auto& text : notes) fmt::print(stderr, "sbatch: {}\n", text);
      if (trouble.empty()) {
        fmt::print("{}: array {} had no merge in the queue: merge {} is submitted\n", study.name,
                   s.record.array_id, s.record.merge_id);
      } else {
        fmt::print(stderr, "{}: {}\n", study.name, trouble);
        code = exit_stopped;
      }
      continue;
    }
    if (s.record.array_id.empty() && s.whole == 0) {
      fmt::print("{}: Slurm did not take {}\n", study.name, s.folder.string());
      close_submission(s.folder);
      continue;
    }
    const auto shards = whole_shards(s);
    fmt::print("{}: {} is no longer in the queue and was not merged: {} of {} shards are whole\n", study.name,
               s.folder.string(), shards.size(), s.record.shards);
    MergeOptions merge{{}, options.results};
    for (const auto& shard : shards) merge.folders.push_back(shard.string());
    const int merged = shards.empty() ? exit_ok : run_merge(merge);
    code = std::max(code, merged);
    s.unmerged = merged == exit_stopped;  // a full disk, say: what is whole is not run again for that
    if (!s.unmerged) close_submission(s.folder);
  }
  return code;
}

/// Deals the jobs out and submits what is not in the queue yet.
int submit_jobs(const RunOptions& options, const Study& study, const std::vector<Job>& jobs,
                const std::vector<Submission>& submissions) {
  print_doubts(submissions);
  const Standing standing = standing_of(options, jobs, submissions);
  const auto& open = standing.to_submit;
  const int code = print_standing(standing, study);
  if (open.empty()) return code;
  const int round = round_of(options, study.name, open);
  if (round > options.slurm.rounds) {
    fmt::print(stderr, "{}: {} left after {}; run again to go on\n", study.name,
               counted(static_cast<std::int64_t>(open.size()), "job"),
               counted(options.slurm.rounds, "round"));
    return exit_stopped;
  }
  const int workers = options.workers > 0 ? options.workers : 1;
  const auto shards = make_shards(open, read_duration("--shard-time", options.slurm.shard_time), workers,
                                  static_cast<std::size_t>(options.slurm.most_shards));
  const SlurmScripts scripts = scripts_for(options, study, shards.size(), workers, round);
  if (options.dry_run) {
    fmt::print("{}\n{}", array_script(scripts), merge_script(scripts));
    return code;
  }
  print_shards(scripts, shards);
  std::vector<std::vector<std::string>> keys;
  for (const auto& shard : shards) {
    keys.emplace_back();
    for (const Job* job : shard.jobs) keys.back().push_back(job->key);
  }
  try {
    const SubmitOutcome outcome = submit(scripts, {study.path, study.points_file}, keys);
    const Submission& submission = outcome.submission;
    for (const auto& text : outcome.notes) fmt::print(stderr, "sbatch: {}\n", text);
    if (outcome.trouble.empty()) {
      fmt::print("submitted: array {}, merge {}; {}\n", submission.record.array_id,
                 submission.record.merge_id, submission.folder.string());
      return code;
    }
    fmt::print(stderr, "{}: {}\n", study.name, outcome.trouble);
    if (outcome.folder_kept)
      fmt::print(stderr, "{}: run again, and Slurm is asked for it first; its folder is {}\n", study.name,
                 submission.folder.string());
    else
      fmt::print(stderr, "{}: nothing is submitted\n", study.name);
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "{}: {}\n", study.name, error.what());
  }
  return exit_stopped;
}

/// A queue runs the jobs: they are submitted, and left.
class SlurmWorkers : public Workers {
 public:
  SlurmWorkers(const RunOptions& options, const Study& study, const std::vector<Submission>& submissions)
      : options_(options), study_(study), submissions_(submissions) {}

  ExecutorReport run(std::vector<Job> jobs, const std::function<void(const ExecutorReport&)>&) override {
    exit_code_ = submit_jobs(options_, study_, jobs, submissions_);
    ExecutorReport report;
    report.untouched = std::ssize(jobs);
    return report;
  }
  unsigned count(std::size_t jobs) const override { return static_cast<unsigned>(jobs); }
  int exit_code() const { return exit_code_; }

 private:
  const RunOptions& options_;
  const Study& study_;
  const std::vector<Submission>& submissions_;
  int exit_code_ = exit_ok;
};

/// Fits and figures; false if one could not be finished.
bool finish_one(const Study& study, const RunOptions& options, const RunSeams& seams, CatalogWriter& writer) {
  try {
    if (seams.finish_study) seams.finish_study(study, options.results, writer);
    return true;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", study.name, error.what());
    return false;
  }
}

}  // namespace

int run_on_slurm(const RunOptions& options, const Study& study, const PlannedStudy& planned,
                 const RunSeams& seams) {
  check_scripts(options);
  if (options.dry_run) {
    const CatalogAnswers known(options.results);
    return submit_jobs(options, study, jobs_wanted(planned, RunAnswers(known, options.retry_failed)),
                       read_submissions(options.results));
  }
  const SubmitLock lock(options.results);
  auto submissions = read_submissions(options.results);
  const int tended = tend(options, study, submissions);
  std::erase_if(submissions, [](const Submission& s) { return is_closed(s.folder); });
  WriterOptions writer_options;
  writer_options.store.git_revision = git_revision();
  CatalogWriter writer(options.results, writer_options);
  SlurmWorkers workers(options, study, submissions);
  Status silent;
  const RunReport report = run_studies(std::span(&planned, 1), writer, workers, silent, signal_flag(),
                                       {options.results, options.retry_failed, {}});
  if (report.left() > 0) return std::max(tended, workers.exit_code());
  const bool good = finish_one(study, options, seams, writer);
  if (const auto search = report.searches.find(study.name); search != report.searches.end()) {
    fmt::print("\n{}: {}\n", study.name, study.title);
    print_search(study, search->second);
    fmt::print("{}{}", failures_text(study, options.results), fits_text(study, options.results));
  } else {
    fmt::print("{}: {} done, {} failed, none left\n", study.name, report.reused, report.left_failed);
    if (!options.quiet) fmt::print("{}\n", results_text(study, options.results));
  }
  // A shard that could not be taken over is told by the exit code, too; what Slurm still holds is of no use.
  return !good || tended == exit_failed ? exit_failed : report.exit_code();
}

}  // namespace mpmstudy
