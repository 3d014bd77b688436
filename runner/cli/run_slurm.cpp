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

SlurmScripts scripts_for(const RunOptions& options, const Study& study, std::size_t shards, int workers) {
  const fs::path results = fs::absolute(options.results).lexically_normal();
  SlurmScripts s;
  s.study = study.name;
  s.program = fs::read_symlink("/proc/self/exe").string();
  s.results = results.string();
  s.folder = (results / "slurm" / submission_name(study.name)).string();
  s.shards = shards;
  s.workers = workers;
  s.round = options.slurm.round;
  s.run = with_flag("--set", options.study.set);
  append_option(s.run, "--timeout", options.timeout);
  append_option(s.run, "--memory", options.memory);
  append_option(s.run, "--retries", std::to_string(options.retries));
  for (const auto& option : options.slurm.options) s.again.push_back("--slurm=" + option);
  append_option(s.again, "--shard-time", options.slurm.shard_time);
  append_option(s.again, "--rounds", std::to_string(options.slurm.rounds));
  append_option(s.again, "-j", std::to_string(workers));
  s.options = options.slurm.options;
  return s;
}

/// Keys that are decided, or wait in the queue. Without a catalog: none.
std::set<std::string> settled_keys(const std::string& results) {
  auto keys = queued_keys(read_submissions(results));
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

}  // namespace

int run_on_slurm(const RunOptions& options, const Study& study, const PlannedStudy& planned,
                 const RunSeams& seams) {
  auto jobs = first_jobs(planned.plan);
  if (!options.dry_run) {
    WriterOptions writer_options;
    writer_options.store.git_revision = git_revision();
    CatalogWriter writer(options.results, writer_options);
    const auto registered =
        writer.register_study(planned.plan.study, planned.title, jobs, options.retry_failed, planned.source);
    if (registered.to_run.empty() && registered.running_elsewhere == 0) {
      Climbs climbs(writer, options.results, options.retry_failed);
      climbs.add(planned.plan);
      jobs = climbs.next();
    }
    if (jobs.empty()) {
      fmt::print("{}: {} done, {} failed, none left\n", study.name, registered.done, registered.failed);
      if (seams.finish_study) seams.finish_study(study, options.results, writer);
      return registered.failed > 0 ? exit_failed : exit_ok;
    }
  }
  const auto settled = settled_keys(options.results);
  std::vector<const Job*> open;
  for (const auto& job : jobs)
    if (!settled.contains(job.key)) open.push_back(&job);
  if (open.empty()) {
    fmt::print("{}: what is left is in the queue; `mpmstudy status` shows it\n", study.name);
    return exit_ok;
  }
  if (options.slurm.round > options.slurm.rounds) {
    fmt::print(stderr, "{}: {} left after {}; run again to go on\n", study.name,
               counted(static_cast<std::int64_t>(open.size()), "job"),
               counted(options.slurm.rounds, "round"));
    return exit_stopped;
  }
  const int workers = options.workers > 0 ? options.workers : 1;
  const auto shards = make_shards(open, read_duration("--shard-time", options.slurm.shard_time), workers,
                                  static_cast<std::size_t>(options.slurm.most_shards));
  const SlurmScripts scripts = scripts_for(options, study, shards.size(), workers);
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

}  // namespace mpmstudy
