#include "runner/cli/run_slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/timestamp.hpp"
#include "runner/cli/amounts.hpp"
#include "runner/cli/print_search.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/ladder/climbs.hpp"
#include "runner/slurm/queue.hpp"
#include "runner/slurm/shards.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// "collapsibility-radius-20310506T070809.123": a folder a submission.
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
  s.folder = (results / "slurm" / submission_name(study.name)).string();
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

/// Keys that are decided, or wait in the queue. Without a catalog: none.
std::set<std::string> settled_keys(const std::string& results, const std::vector<Submission>& submissions) {
  auto keys = queued_keys(submissions);
  if (fs::exists(catalog_path(results)))
    for (const auto& row :
         query(results, "SELECT DISTINCT key FROM jobs WHERE status IN ('done', 'failed')").rows)
      keys.insert(std::get<std::string>(row[0]));
  return keys;
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

/// Deals the jobs out and submits what is not in the queue yet.
int submit_jobs(const RunOptions& options, const Study& study, const std::vector<Job>& jobs) {
  const auto submissions = read_submissions(options.results);
  if (!options.dry_run)
    for (const auto& id : release_stranded(submissions))
      fmt::print("{}: Slurm could not start element {} and held it; it is released\n", study.name, id);
  const auto settled = settled_keys(options.results, submissions);
  std::vector<const Job*> open;
  for (const auto& job : jobs)
    if (!settled.contains(job.key)) open.push_back(&job);
  if (open.empty()) {
    fmt::print("{}: what is left is in the queue; `mpmstudy status` shows it\n", study.name);
    return exit_ok;
  }
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
    return exit_ok;
  }
  print_shards(scripts, shards);
  std::vector<std::vector<std::string>> keys;
  for (const auto& shard : shards) {
    keys.emplace_back();
    for (const Job* job : shard.jobs) keys.back().push_back(job->key);
  }
  try {
    const Submission submission = submit(scripts, study.path, keys);
    fmt::print("submitted: array {}, merge {}; {}\n", submission.array_id, submission.merge_id,
               submission.folder.string());
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "{}: {}\n", study.name, error.what());
    return exit_stopped;
  }
  return exit_ok;
}

/// What is left of a study once it is registered: its open jobs, or the next ones of its ladders.
std::vector<Job> open_jobs(const PlannedStudy& planned, const RunOptions& options, CatalogWriter& writer,
                           Registration& registered) {
  auto jobs = first_jobs(planned.plan);
  registered =
      writer.register_study(planned.plan.study, planned.title, jobs, options.retry_failed, planned.source);
  if (registered.to_run.empty() && registered.running_elsewhere == 0) {
    Climbs climbs(writer, options.results, options.retry_failed);
    climbs.add(planned.plan);
    return climbs.next();
  }
  return jobs;
}

}  // namespace

int run_on_slurm(const RunOptions& options, const Study& study, const PlannedStudy& planned,
                 const RunSeams& seams) {
  if (options.dry_run) return submit_jobs(options, study, first_jobs(planned.plan));
  WriterOptions writer_options;
  writer_options.store.git_revision = git_revision();
  CatalogWriter writer(options.results, writer_options);
  Registration registered;
  const auto jobs = open_jobs(planned, options, writer, registered);
  if (!jobs.empty()) return submit_jobs(options, study, jobs);
  fmt::print("{}: {} done, {} failed, none left\n", study.name, registered.done, registered.failed);
  if (seams.finish_study) seams.finish_study(study, options.results, writer);
  return registered.failed > 0 ? exit_failed : exit_ok;
}

int search_on_slurm(const RunOptions& options, const Study& study, const SearchOptions& search,
                    const RunSeams& seams) {
  if (options.dry_run) {
    Search first(study);
    Study round = study;
    round.scenes = first.next_round();
    return submit_jobs(options, study, make_plan(round, search.cost).jobs);
  }
  WriterOptions writer_options;
  writer_options.store.git_revision = git_revision();
  CatalogWriter writer(options.results, writer_options);
  int code = exit_ok;
  const RunRound submit_round = [&](const PlannedStudy& planned) {
    RunReport report;
    Registration registered;
    const auto jobs = open_jobs(planned, options, writer, registered);
    report.reused = registered.done;
    report.left_failed = registered.failed;
    report.executed.untouched =
        static_cast<std::int64_t>(registered.to_run.size()) + registered.running_elsewhere;
    if (report.left() > 0) code = submit_jobs(options, study, jobs);
    return report;
  };
  const SearchReport report = run_search(study, search, writer, options.results, submit_round);
  if (report.run.left() > 0) return code;
  print_search(study, report);
  if (seams.finish_study) seams.finish_study(study, options.results, writer);
  return report.exit_code();
}

}  // namespace mpmstudy
