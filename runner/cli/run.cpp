#include "runner/cli/run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string_view>
#include <unordered_set>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/file_system.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/cli/amounts.hpp"
#include "runner/cli/print_search.hpp"
#include "runner/cli/run_slurm.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/exec/run_search.hpp"
#include "runner/exec/run_studies.hpp"
#include "runner/exec/signals.hpp"
#include "runner/status/label.hpp"
#include "runner/status/terminal_status.hpp"

namespace mpmstudy {
namespace {

/// Names of what jobs differ in: what any of the studies sweeps or searches, in the order in which they
/// occur, and the cell where one has a ladder of them.
std::vector<std::string> swept_names(const std::vector<Study>& studies) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const auto& study : studies) {
    std::ranges::for_each(study.swept, add);
    if (study.search) add(study.search->critical);
  }
  if (std::ranges::any_of(studies, [](const Study& study) { return study.ladder.cells > 1; }))
    add("cell_size");
  return names;
}

/// Two files with one name would take each other's jobs away.
void check_names(const std::vector<Study>& studies) {
  std::map<std::string, std::filesystem::path> seen;
  for (const auto& study : studies)
    if (const auto [other, is_new] = seen.emplace(study.name, study.path); !is_new)
      throw StudyError(study.path.string() + ": name = \"" + study.name + "\": is also the name of " +
                       other->second.string() + "; studies that share a catalog have names of their own");
}

std::unique_ptr<Status> make_status(const RunOptions& options, const std::vector<Study>& studies) {
  const char* term = std::getenv("TERM");
  const bool live = isatty(STDOUT_FILENO) != 0 && term != nullptr && std::string_view(term) != "dumb";
  if (live && !options.quiet && !options.verbose) {
    TerminalOptions terminal;
    terminal.swept = swept_names(studies);
    return make_terminal_status(std::cout, terminal);
  }
  return make_plain_status(std::cout, {options.verbose ? 2.0 : 30.0, swept_names(studies), options.quiet});
}

/// --dry-run: what a run would do. Writes nothing, and needs no catalog.
int print_intent(const RunOptions& options, const std::vector<Study>& studies,
                 const std::vector<PlannedStudy>& planned, const CostModel& cost) {
  std::map<std::string, std::string> known;
  if (std::filesystem::exists(catalog_path(options.results)))
    for (const auto& row : query(options.results, "SELECT DISTINCT key, status FROM jobs").rows)
      known[std::get<std::string>(row[0])] = std::get<std::string>(row[1]);
  std::vector<Job> jobs;
  std::map<std::string, std::int64_t> kept;
  std::set<std::string> seen;
  double seconds = 0;
  for (const auto& study : planned)
    for (const auto& job : jobs_to_run(study)) {
      if (!seen.insert(job.key).second) continue;
      const auto status = known.contains(job.key) ? known[job.key] : "planned";
      if (status == "done" || (status == "failed" && !options.retry_failed)) {
        ++kept[status];
        continue;
      }
      jobs.push_back(job);
      seconds += job.predicted_seconds;
    }
  std::ranges::stable_sort(jobs, std::ranges::greater{}, &Job::predicted_seconds);
  const auto swept = swept_names(studies);
  for (const auto& job : jobs)
    fmt::print("{}  {} particles, {} steps, {}  {}\n", short_key(job.key), job.estimate.particles,
               job.estimate.steps, readable_duration(job.predicted_seconds), label_of(job.scene, swept));
  auto count = static_cast<std::int64_t>(jobs.size());
  bool about = false;
  for (const auto& study : studies) {
    if (!study.search || !options.only.empty()) continue;
    const SearchForecast forecast = forecast_search(study, options.results, options.retry_failed);
    fmt::print("{}: {}\n", study.name, readable_forecast(study, forecast));
    for (const auto& round : forecast.rounds)
      for (const auto& scene : round) seconds += cost.seconds(mpm::estimate(scene));
    count += forecast.runs;
    about |= forecast.runs > 0;
  }
  fmt::print("{}{} would run, about {} of one core; {} done, {} failed and would be left\n",
             about ? "about " : "", counted(count, "job"), readable_duration(seconds), kept["done"],
             kept["failed"]);
  return exit_ok;
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

/// Keys of jobs from a file, separated by blanks or ends of lines: key -> line. Throws StudyError.
std::map<std::string, int> read_keys(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw StudyError(path + ": cannot be read; --only names a file of keys, one per line");
  std::map<std::string, int> keys;
  int number = 1;
  for (std::string line; std::getline(file, line); ++number) {
    std::istringstream words(line);
    for (std::string key; words >> key;) keys.emplace(key, number);
  }
  if (keys.empty()) throw StudyError(path + ": holds no key; --only names a file of keys, one per line");
  return keys;
}

/// Has only the jobs run whose keys are in a file. Throws StudyError naming those that no study has.
void choose(const std::string& path, const std::map<std::string, int>& lines,
            std::vector<PlannedStudy>& planned) {
  std::unordered_set<std::string> keys, known;
  for (const auto& [key, line] : lines) keys.insert(key);
  std::string names;
  for (auto& study : planned) {
    study.selection.keys = keys;
    for (const auto& job : jobs_to_run(study)) known.insert(job.key);
    names += (names.empty() ? "" : ", ") + study.plan.study;
  }
  std::string unknown;
  std::size_t more = 0;
  for (const auto& [key, line] : lines) {
    if (known.contains(key)) continue;
    if (++more <= 5) unknown += fmt::format("{}:{}: {}\n", path, line, key);
  }
  if (more > 5) unknown += fmt::format("and {} more\n", more - 5);
  if (more > 0)
    throw StudyError(unknown + "no job of " + names +
                     " has such a key as the study is now; `mpmstudy plan --json` lists the keys, of 32 "
                     "hexadecimal digits");
}

StudySource source_of(const Study& study, const StudyOptions& options) {
  return {std::filesystem::absolute(study.path).lexically_normal().string(), options.set, options.cells};
}

/// "5 %", "5%" or "0.05". Throws StudyError.
double share_of(const std::string& text) {
  std::size_t end = 0;
  double share = -1;
  try {
    share = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  std::string rest = text.substr(std::min(end, text.size()));
  std::erase(rest, ' ');
  if (rest == "%") share /= 100;
  if (end == 0 || (!rest.empty() && rest != "%") || !(share >= 0 && share <= 1))
    throw StudyError("--audit: " + text + ": not a share; write for example --audit \"5 %\"");
  return share;
}

/// A runner that says nothing for twelve periods is taken for gone where nobody can look for its process.
void set_heartbeat(const RunOptions& options, WriterOptions& writer) {
  const double period_s = read_duration("--heartbeat", options.heartbeat);
  if (!(period_s > 0)) throw StudyError("--heartbeat: " + options.heartbeat + ": not above 0 s");
  writer.heartbeat = std::chrono::milliseconds(static_cast<std::int64_t>(std::max(1.0, 1000 * period_s)));
  writer.store.heartbeat_expires_s = 12 * period_s;
}

SearchOptions from(StudySource source, SearchOptions search) {
  search.source = std::move(source);
  return search;
}

/// A job array a study.
int submit_studies(const RunOptions& options, const std::vector<Study>& studies,
                   const std::vector<PlannedStudy>& planned, const SearchOptions& search,
                   const RunSeams& seams) {
  int code = exit_ok;
  auto next = planned.begin();
  for (const auto& study : studies)
    code = std::max(code, study.search ? search_on_slurm(options, study,
                                                         from(source_of(study, options.study), search), seams)
                                       : run_on_slurm(options, study, *next++, seams));
  return code;
}

/// Plans of the studies that are no search; with --only, of what a search may ask for too.
std::vector<PlannedStudy> plan_studies(const RunOptions& options, const std::vector<Study>& studies,
                                       const CostModel& cost) {
  std::vector<PlannedStudy> planned;
  const auto keys = options.only.empty() ? std::map<std::string, int>() : read_keys(options.only);
  for (Study study : studies) {
    if (study.search && options.only.empty()) continue;
    if (study.search)
      study.scenes = possible_scenes(study, [&](const std::string& key) { return keys.contains(key); });
    planned.push_back({make_plan(study, cost), study.title, source_of(study, options.study), {}});
    if (options.only.empty()) continue;
    auto& members = planned.back().selection.members;
    if (study.search || options.shard)
      members = Members::also;
    else if (!planned.back().plan.ladders.empty())
      members = Members::at_least;
  }
  if (!options.only.empty()) choose(options.only, keys, planned);
  return planned;
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
  verb.add_option(
          "--audit", options->audit,
          "Of the runs of a [search] that stopped when decided, run this share to the end and compare")
      ->type_name("\"5 %\"")
      ->capture_default_str();
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options, seams] { finish(run_run(*options, *seams)); });
}

int run_run(const RunOptions& options, const RunSeams& seams) {
  std::vector<Study> studies;
  for (const auto& file : options.files) studies.push_back(read_study(file, options.study));
  check_names(studies);
  const CostModel cost(measured_costs(options.results));
  const SearchOptions search_options{cost, options.retry_failed, share_of(options.audit), {}};
  const auto planned = plan_studies(options, studies, cost);
  if (const auto note = share_note(options.results); !note.empty() && !options.dry_run)
    fmt::print(stderr, "{}\n", note);
  if (options.engine == "slurm") return submit_studies(options, studies, planned, search_options, seams);
  if (options.dry_run) return print_intent(options, studies, planned, cost);

  const ExecutorOptions executor = executor_options(options);
  const SignalGuard signals;
  WriterOptions writer_options;
  writer_options.store.git_revision = git_revision();
  set_heartbeat(options, writer_options);
  CatalogWriter writer(options.results, writer_options);
  const auto status = make_status(options, studies);
  RunReport report;
  int code = exit_ok;
  try {
    if (!planned.empty())
      report = run_studies(planned, options.retry_failed, writer, *status, seams.simulate,
                           seams.write_snapshot, signal_flag(), executor);
    for (const auto& study : studies) {
      if (!study.search || !options.only.empty() || report.left() > 0) continue;
      const SearchReport search =
          run_search(study, from(source_of(study, options.study), search_options), writer, *status,
                     seams.simulate, seams.write_snapshot, signal_flag(), executor);
      report += search.run;
      code = std::max(code, search.exit_code());
      if (search.run.left() == 0)
        print_search(study, search);
      else
        fmt::print(stderr, "{}: the search is not at its end; run again to go on\n", study.name);
    }
  } catch (const CatalogError& error) {  // on the way, so there is work left
    fmt::print(stderr, "{}\nrun again to go on\n", error.what());
    return exit_stopped;
  }
  const bool whole = report.left() == 0 && options.only.empty();
  const bool good = !whole || finish_studies(studies, options, seams, writer);
  code = std::max(code, report.exit_code());
  return code == exit_ok && !good ? exit_failed : code;
}

}  // namespace mpmstudy
