#include "runner/cli/run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <string_view>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/file_system.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/cli/amounts.hpp"
#include "runner/cli/job_labels.hpp"
#include "runner/cli/json_results.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/cli/print_failures.hpp"
#include "runner/cli/print_results.hpp"
#include "runner/cli/print_search.hpp"
#include "runner/cli/quiet_stdout.hpp"
#include "runner/cli/run_intent.hpp"
#include "runner/cli/run_plan.hpp"
#include "runner/cli/run_slurm.hpp"
#include "runner/cli/skipped_points.hpp"
#include "runner/cli/surface_text.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/exec/run_studies.hpp"
#include "runner/exec/signals.hpp"
#include "runner/status/label.hpp"
#include "runner/status/terminal_status.hpp"

namespace mpmstudy {
namespace {

/// Two files with one name would take each other's jobs away.
void check_names(const std::vector<Study>& studies) {
  std::map<std::string, std::filesystem::path> seen;
  for (const auto& study : studies)
    if (const auto [other, is_new] = seen.emplace(study.name, study.path);
        !is_new && other->second == study.path)
      throw StudyError(study.path.string() + ": is given twice");
    else if (!is_new)
      throw StudyError(study.path.string() + ": name = \"" + study.name + "\": is also the name of " +
                       other->second.string() + "; studies that share a catalog have names of their own");
}

std::unique_ptr<Status> make_status(const RunOptions& options, const JobLabels& labels) {
  const auto label = [&labels](const Job& job) { return labels(job); };
  const char* term = std::getenv("TERM");
  const bool live = isatty(STDOUT_FILENO) != 0 && term != nullptr && std::string_view(term) != "dumb";
  if (live && !options.quiet && !options.verbose) {
    TerminalOptions terminal;
    terminal.label = label;
    return make_terminal_status(std::cout, terminal);
  }
  PlainOptions plain;
  if (options.verbose) plain.progress_every_s = 2;
  plain.quiet = options.quiet;
  plain.label = label;
  return make_plain_status(std::cout, plain);
}

/// Fits and figures of every study; false if one could not be finished.
bool finish_studies(const std::vector<Study>& studies, const RunOptions& options, const RunSeams& seams,
                    CatalogWriter& writer) {
  bool good = true;
  for (const auto& study : studies) try {
      if (seams.finish_study) seams.finish_study(study, options.results, writer);
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}: {}\n", study.name, error.what());
      good = false;
    }
  return good;
}

/// What each study has come to, in the order of the command line; quiet: brackets of searches only.
void print_studies(const std::vector<Study>& studies, const std::map<std::string, SearchReport>& searches,
                   const std::filesystem::path& results, bool quiet) {
  for (const auto& study : studies) {
    const std::string skipped = skipped_text(study);
    if (const auto search = searches.find(study.name); search != searches.end()) {
      fmt::print("\n{}: {}\n", study.name, study.title);
      print_search(study, search->second);
      fmt::print("{}{}", failures_text(study, results), fits_text(study, results));
    } else if (!quiet) {
      fmt::print("{}{}", results_text(study, results), tolerance_text(study, results));
    }
    fmt::print("{}", skipped);
  }
  if (!quiet) fmt::print("\n");
}

ExecutorOptions executor_options(const RunOptions& options) {
  ExecutorOptions executor;
  executor.results = options.results;
  executor.workers = static_cast<unsigned>(options.workers);
  executor.retries = options.retries;
  executor.limits = {read_duration("--timeout", options.timeout), read_bytes("--memory", options.memory)};
  executor.checkpoint_s = read_duration("--checkpoint", options.checkpoint);
  executor.budget_s = read_duration("--budget", options.budget);
  executor.abandon = [](const ExecutorReport&) {
    std::fflush(nullptr);
    std::_Exit(signal_flag().signal() == SIGINT ? exit_interrupted : exit_stopped);
  };
  return executor;
}

/// A runner without a sign of life for twelve periods is taken for gone where its process cannot be looked
/// for.
void set_heartbeat(const RunOptions& options, WriterOptions& writer) {
  const double period_s = read_duration("--heartbeat", options.heartbeat);
  if (!(period_s > 0)) throw StudyError("--heartbeat: " + options.heartbeat + ": not above 0 s");
  writer.heartbeat = std::chrono::milliseconds(static_cast<std::int64_t>(std::max(1.0, 1000 * period_s)));
  writer.store.heartbeat_expires_s = 12 * period_s;
}

/// One job array per study.
int submit_studies(const RunOptions& options, const std::vector<Study>& studies,
                   const std::vector<PlannedStudy>& planned, const RunSeams& seams) {
  int code = exit_ok;
  for (std::size_t i = 0; i < studies.size(); ++i)
    code = std::max(code, run_on_slurm(options, studies[i], planned[i], seams));
  return code;
}

void say_what_is_replaced(const std::vector<Study>& studies, const std::vector<PlannedStudy>& planned,
                          const RunOptions& options) {
  for (std::size_t i = 0; i < studies.size(); ++i)
    say_what_is_replaced(studies[i], studies[i].search ? nullptr : &planned[i].plan, options.study,
                         options.results, options.dry_run);
}

}  // namespace

void setup_run(CLI::App& app, RunSeams given) {
  const auto options = std::make_shared<RunOptions>();
  const auto seams = std::make_shared<RunSeams>(std::move(given));
  CLI::App& verb = *app.add_subcommand("run", "Run what is not decided yet; running again goes on");
  verb.add_option("STUDY", options->files, "Study files")->required();
  verb.add_option("-j,--jobs", options->workers, "Jobs at a time [processors]")->check(CLI::Range(1, 4096));
  verb.add_flag("-n,--dry-run", options->dry_run, "Say what would run; write nothing");
  verb.add_flag("--retry-failed", options->retry_failed, "Run failed jobs again");
  verb.add_option("--retries", options->retries, "How often a failed job is run again")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  verb.add_option("--timeout", options->timeout, "A job that runs longer is failed")->type_name("\"10 min\"");
  verb.add_option("--memory", options->memory,
                  "A job that needs more is failed; each job then has a process of its own")
      ->type_name("\"2 GB\"");
  verb.add_option("--checkpoint", options->checkpoint,
                  "Processor time between the checkpoints from which a long job goes on; 0: none")
      ->type_name("\"60 s\"")
      ->capture_default_str();
  verb.add_option("--heartbeat", options->heartbeat,
                  "Period of signs of life; after twelve without one other machines may take the jobs")
      ->type_name("\"5 s\"")
      ->capture_default_str();
  verb.add_option("--budget", options->budget, "Start no more jobs after this time")->type_name("\"2 h\"");
  verb.add_option("--engine", options->engine, "Where jobs run: local, or slurm (a job array and its merge)")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  verb.add_option("--slurm", options->slurm.options, "An option for sbatch: --slurm=--partition=long")
      ->allow_extra_args(false);
  verb.add_option("--shard-time", options->slurm.shard_time, "Predicted time of one element of the array")
      ->capture_default_str();
  verb.add_option("--shards", options->slurm.most_shards, "No more elements than this")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  verb.add_option("--rounds", options->slurm.rounds, "Submit what is left so often")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb.add_option("--round", options->slurm.round)->group("");  // said by the merge of the round before
  verb.add_option("--only", options->only, "Run the jobs whose keys are in this file")->type_name("FILE");
  verb.add_flag("--shard", options->shard)->needs("--only")->group("");  // said by the elements of an array
  auto* quiet = verb.add_flag("-q,--quiet", options->quiet, "Failures and the summary only");
  verb.add_flag("-v,--verbose", options->verbose, "Lines instead of a live display, and more of them")
      ->excludes(quiet);
  verb.add_flag("--json", options->json,
                "At the end one JSON object with the results of every job; all else goes to standard error")
      ->excludes("--dry-run")
      ->excludes("--only");
  verb.add_option(
          "--audit", options->audit,
          "Of the runs of a [search] that stopped when decided, run this share to the end and compare")
      ->type_name("\"5 %\"")
      ->capture_default_str();
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options, seams] { end_with(run_run(*options, *seams)); });
}

namespace {

/// Options that would be of no effect. Throws StudyError.
void refuse_idle_options(const RunOptions& options, const std::vector<Study>& studies) {
  const SlurmOptions &said = options.slurm, plain;
  if (options.engine != "slurm" && (!said.options.empty() || said.shard_time != plain.shard_time ||
                                    said.most_shards != plain.most_shards || said.rounds != plain.rounds))
    throw StudyError(
        "--slurm, --shard-time, --shards and --rounds are for --engine slurm; without it the jobs would run "
        "on "
        "this machine");
  if (options.engine == "slurm" && options.json)
    throw StudyError(
        "--json: does not go with --engine slurm, which ends before its jobs; `show --json` later");
  if (options.engine == "slurm" && !options.only.empty())
    throw StudyError("--only " + options.only +
                     ": does not go with --engine slurm, which deals out all jobs");
  if (share_of(options.audit) > 0 &&
      std::ranges::none_of(studies, [](const Study& study) { return study.search.has_value(); }))
    throw StudyError("--audit " + options.audit + ": none of these studies has a [search] to audit");
}

int run_all(const RunOptions& options, const std::vector<Study>& studies, const RunSeams& seams) {
  check_names(studies);
  const CostModel cost(measured_costs(options.results));
  const auto planned = plan_studies(options, studies, cost);
  if (options.only.empty()) say_what_is_replaced(studies, planned, options);
  if (const auto note = share_note(options.results); !note.empty() && !options.dry_run)
    fmt::print(stderr, "{}\n", note);
  if (options.only.empty()) warn_and_ask(options, studies, planned, cost);
  if (options.engine == "slurm") return submit_studies(options, studies, planned, seams);
  JobLabels labels(studies);
  if (options.dry_run) {
    for (std::size_t i = 0; i < planned.size(); ++i) labels.add(jobs_to_run(planned[i]), i);
    return print_intent(options, studies, planned, cost, labels);
  }

  const ExecutorOptions executor = executor_options(options);
  const SignalGuard signals;
  WriterOptions writer_options;
  writer_options.store.git_revision = git_revision();
  set_heartbeat(options, writer_options);
  CatalogWriter writer(options.results, writer_options);
  const auto status = make_status(options, labels);
  ThreadWorkers workers(seams.simulate, seams.write_snapshot, writer, *status, signal_flag(), executor);
  const EngineOptions engine{
      options.results, options.retry_failed,
      [&](std::size_t study, const std::vector<Job>& jobs) { labels.add(jobs, study); }};
  RunReport report;
  try {
    report = run_studies(planned, writer, workers, *status, signal_flag(), engine);
  } catch (const CatalogError& error) {  // on the way, so there is work left
    fmt::print(stderr, "{}\nrun again to go on\n", error.what());
    return exit_stopped;
  }
  const bool whole = report.left() == 0 && options.only.empty();
  const bool good = !whole || finish_studies(studies, options, seams, writer);
  if (report.left() > 0)
    for (const Study& study : studies)
      if (study.search && options.only.empty() && !report.searches.contains(study.name))
        fmt::print(stderr, "{}: the search is not at its end; run again to go on\n", study.name);
  if (whole) print_studies(studies, report.searches, options.results, options.quiet);
  fmt::print("catalog: {}\n", catalog_path(options.results).string());
  const int code = report.exit_code();
  return code == exit_ok && !good ? exit_failed : code;
}

}  // namespace

int run_run(const RunOptions& options, const RunSeams& seams) {
  std::vector<Study> studies;
  for (const auto& file : options.files) studies.push_back(read_study(file, options.study));
  refuse_idle_options(options, studies);
  if (!options.json) return run_all(options, studies, seams);
  int code = exit_ok;
  {
    const QuietStdout until_the_end;
    code = run_all(options, studies, seams);
  }
  fmt::print("{}\n", results_json(studies, options.results, code));
  return code;
}

}  // namespace mpmstudy
