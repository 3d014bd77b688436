#include "runner/cli/status.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "runner/catalog/accuracy.hpp"
#include "runner/cli/ask.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {
namespace {

using Json = nlohmann::ordered_json;

constexpr JobStatus all_states[] = {JobStatus::planned, JobStatus::running, JobStatus::done,
                                    JobStatus::failed, JobStatus::cancelled};

std::int64_t count(const StudyState& study, JobStatus status) {
  const auto found = study.jobs.find(status);
  return found == study.jobs.end() ? 0 : found->second;
}

/// How jobs that no study has are listed and counted.
constexpr std::string_view nobody = "(no study)";
std::string_view name_of(std::string_view study) { return study.empty() ? nobody : study; }

Json counts(const StudyState& study) {
  Json jobs;
  for (const auto status : all_states) jobs[std::string(to_string(status))] = count(study, status);
  return jobs;
}

/// The name of a study, or null.
Json study_or_null(const std::string& study) { return study.empty() ? Json(nullptr) : Json(study); }

/// Of the files of a study, or of none.
std::int64_t bytes_of(const DiskUse& disk, const std::string& study) {
  const auto found = std::ranges::find(disk.studies, study, &DiskUse::OfStudy::study);
  return found == disk.studies.end() ? 0 : found->bytes;
}

Json to_json(const CatalogState& state, const std::vector<Submission>& submissions,
             const std::optional<DiskUse>& disk) {
  Json json = {{"studies", Json::array()}, {"no_study", counts(state.no_study)}, {"stale", state.stale},
               {"slurm", Json::array()},   {"running", Json::array()},           {"failed", Json::array()}};
  for (const auto& study : state.studies) {
    json["studies"].push_back({{"study", study.name}, {"title", study.title}, {"jobs", counts(study)}});
    if (disk) json["studies"].back()["fields_bytes"] = bytes_of(*disk, study.name);
  }
  if (disk)
    json["disk"] = {{"catalog_bytes", disk->catalog},
                    {"fields_bytes", disk->fields},
                    {"no_study_bytes", bytes_of(*disk, "")}};
  for (const auto& s : submissions)
    json["slurm"].push_back({{"study", s.record.study},
                             {"array", s.record.array_id},
                             {"folder", s.folder.string()},
                             {"unknown", s.unknown.empty() ? Json(nullptr) : Json(s.unknown)},
                             {"shards", s.record.shards},
                             {"whole", s.whole},
                             {"running", s.running},
                             {"pending", s.pending},
                             {"held", s.held},
                             {"merge_queued", s.merge_queued}});
  for (const auto& job : state.running)
    json["running"].push_back({{"key", job.key},
                               {"study", study_or_null(job.study)},
                               {"by", job.by},
                               {"since", job.since},
                               {"attempt", job.attempt},
                               {"gone", job.gone.empty() ? Json(nullptr) : Json(job.gone)},
                               {"last_sign", job.last_sign.empty() ? Json(nullptr) : Json(job.last_sign)}});
  for (const auto& job : state.failed)
    json["failed"].push_back({{"key", job.key}, {"study", study_or_null(job.study)}, {"reason", job.reason}});
  return json;
}

/// " (2 held: ...)"
std::string held(const Submission& s) {
  if (s.held == 0) return "";
  return fmt::format(
      " ({} held{})", s.held,
      s.stranded.empty()
          ? ": `scontrol release` lets them go on"
          : fmt::format(", {} after a failed launch: `mpmstudy run --engine slurm` releases them",
                        s.stranded.size()));
}

void print_queue(const std::vector<Submission>& submissions) {
  if (!submissions.empty()) fmt::print("\nslurm\n");
  for (const auto& s : submissions) {
    const auto array = s.record.array_id.empty() ? s.folder.string() : "array " + s.record.array_id;
    const auto whole = fmt::format("{} of {} shards whole", s.whole, s.record.shards);
    if (!s.unknown.empty()) {
      fmt::print("  {}  {}: {}; not known whether it is in the queue: {}\n", s.record.study, array, whole,
                 s.unknown);
      continue;
    }
    if (s.record.array_id.empty() && s.whole == 0) {
      fmt::print("  {}  {}: Slurm did not take it; `mpmstudy run --engine slurm` submits what is left\n",
                 s.record.study, array);
      continue;
    }
    const char* merge = s.merge_queued ? "waits for them"
                        : s.array_queued()
                            ? "is not in the queue: `mpmstudy run --engine slurm` submits it"
                            : "is lost: `mpmstudy run --engine slurm` takes over what is whole and submits "
                              "what is left";
    fmt::print("  {}  {}: {}, {} running, {} pending{}; merge {}\n", s.record.study, array, whole, s.running,
               s.pending, held(s), merge);
  }
}

/// What follows for the jobs that are listed as running; once, not for each.
void print_who_runs(const std::vector<RunningJob>& running) {
  std::map<std::string, std::string> far;  // who -> last sign of life
  for (const auto& job : running)
    if (job.gone.empty() && !job.last_sign.empty()) far[job.by] = job.last_sign;
  for (const auto& [who, sign] : far)
    fmt::print("  {} cannot be looked for from here; its last sign of life was at {} by its own clock\n", who,
               sign);
  const auto gone = [](const RunningJob& job) { return !job.gone.empty(); };
  if (std::ranges::any_of(running, gone))
    fmt::print("  `mpmstudy run` of a study takes up its jobs whose process has gone\n");
}

/// One line; the studies that have most are named.
void print_disk(const CatalogState& state, const DiskUse& disk, bool all) {
  const auto readable = [](std::int64_t bytes) { return readable_bytes(static_cast<double>(bytes)); };
  std::vector<std::pair<std::int64_t, std::string>> studies;
  for (const auto& study : state.studies)
    if (const auto bytes = bytes_of(disk, study.name); bytes > 0) studies.emplace_back(bytes, study.name);
  std::ranges::stable_sort(studies, std::ranges::greater{}, [](const auto& s) { return s.first; });
  constexpr std::size_t most = 3;
  std::string named;
  for (std::size_t i = 0; i < std::min(most, studies.size()); ++i)
    named += fmt::format("{}{} {}", i == 0 ? "" : ", ", studies[i].second, readable(studies[i].first));
  if (studies.size() > most) named += fmt::format(", {} more", studies.size() - most);
  fmt::print("\ndisk: catalog {}, fields {}{}", readable(disk.catalog), readable(disk.fields),
             named.empty() ? "" : " (" + named + ")");
  if (const auto free = bytes_of(disk, ""); all && free > 0)
    fmt::print("; {} of them are of jobs that no study has (`mpmstudy gc` frees them)", readable(free));
  fmt::print("\n");
}

void print_text(const StudiesReport& report) {
  const auto& [state, submissions, disk, missed, all] = report;
  auto rows = state.studies;
  if (!state.no_study.jobs.empty()) rows.push_back(state.no_study);
  std::size_t width = 5;
  for (const auto& study : rows) width = std::max(width, name_of(study.name).size());
  fmt::print("{:<{}}", "study", width);
  for (const auto status : all_states) fmt::print("  {:>9}", to_string(status));
  fmt::print("\n");
  for (const auto& study : rows) {
    fmt::print("{:<{}}", name_of(study.name), width);
    for (const auto status : all_states) fmt::print("  {:>9}", count(study, status));
    fmt::print("\n");
  }
  if (disk) print_disk(state, *disk, all);
  print_queue(submissions);
  if (state.stale > 0)
    fmt::print("\n{} are of an older physics version: never reused, in no fit (stale = 1 in the view jobs)\n",
               counted(state.stale, "job"));
  if (!state.running.empty()) fmt::print("\nrunning\n");
  for (const auto& job : state.running)
    fmt::print("{}\n", cut_text(fmt::format("  {}  {}  by {} since {}, attempt {}{}", short_key(job.key),
                                            name_of(job.study), job.by, job.since, job.attempt,
                                            job.gone.empty() ? "" : ": " + job.gone),
                                line_columns));
  print_who_runs(state.running);
  if (!state.failed.empty()) fmt::print("\nfailed\n");
  for (const auto& job : state.failed)
    fmt::print("{}\n", cut_text(fmt::format("  {}  {}  {}", short_key(job.key), name_of(job.study),
                                            first_line(job.reason)),
                                line_columns));
}

/// Accuracies that were not reached, searches without a bracket: `run` ends with 1 for them, too.
bool any_missed(const std::string& results, const CatalogState& state) {
  const auto missed = studies_that_missed(results);
  return std::ranges::any_of(state.studies, [&](const StudyState& study) {
    return std::ranges::find(missed, study.name) != missed.end();
  });
}

}  // namespace

void setup_status(CLI::App& app) {
  const auto options = std::make_shared<StatusOptions>();
  CLI::App& verb = *app.add_subcommand("status", "Say how far the studies are");
  verb.add_option("STUDY", options->studies, "Names of studies, or study files [all]");
  verb.add_flag("--json", options->json, "One JSON object");
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_status(*options)); });
}

std::vector<std::string> study_names(const std::vector<std::string>& names_or_files) {
  std::vector<std::string> names;
  for (const auto& study : names_or_files)
    names.push_back(std::filesystem::is_regular_file(study) ? read_study(study, StudyOptions{}).name : study);
  return names;
}

int StudiesReport::exit_code() const {
  // What the queue of a cluster does not tell may still be running.
  if (std::ranges::any_of(submissions, [](const auto& s) { return !s.unknown.empty(); })) return exit_stopped;
  bool failed = missed;
  for (const auto& study : state.studies) {
    if (count(study, JobStatus::planned) + count(study, JobStatus::running) > 0) return exit_stopped;
    failed = failed || count(study, JobStatus::failed) > 0;
  }
  return failed ? exit_failed : exit_ok;
}

StudiesReport read_report(const StatusOptions& options) {
  StudiesReport report;
  report.state = read_state(options.results, study_names(options.studies));
  report.submissions = read_submissions(options.results);
  report.all = options.studies.empty();
  report.missed = any_missed(options.results, report.state);
  return report;
}

void print_report(const StudiesReport& report, bool json) {
  if (json)
    fmt::print("{}\n", to_json(report.state, report.submissions, report.disk)
                           .dump(2, ' ', false, Json::error_handler_t::replace));
  else
    print_text(report);
}

int run_status(const StatusOptions& options) {
  auto report = read_report(options);
  report.disk = disk_use(options.results);
  print_report(report, options.json);
  return report.exit_code();
}

}  // namespace mpmstudy
