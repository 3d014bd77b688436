#include "runner/cli/explain.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/physics_version.hpp"
#include "libmpm/simulation.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/job_states.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/plan/composition_text.hpp"
#include "runner/plan/plan.hpp"
#include "runner/search/search_planner.hpp"
#include "runner/status/label.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

/// A job of a study file, and the study that says where its values stand.
struct Wanted {
  Study study;
  Job job;
  bool of_an_audit = false;  ///< of a search: no round has it, an audit runs it to its end
};

/// One parameter that two scenes do not share.
struct Change {
  std::string_view name;
  std::string here, there;
};

/// Names of those gauges that the others lack, or have in another form: "rear, push"; "none".
std::string own_of(const std::vector<mpm::Gauge>& gauges, const std::vector<mpm::Gauge>& others) {
  std::string names;
  for (const mpm::Gauge& gauge : gauges)
    if (std::ranges::find(others, gauge) == others.end()) names += (names.empty() ? "" : ", ") + gauge.name;
  return names.empty() ? "none" : names;
}

std::vector<Change> changes(const mpm::Scene& here, const mpm::Scene& there) {
  std::vector<Change> all;
  for (const auto& q : mpm::quantities())
    if (!q.derived && q.belongs_to(here.kind) && q.get(here) != q.get(there))
      all.push_back({q.name, readable(q, here), readable(q, there)});
  for (const auto& c : mpm::choices())
    if (c.belongs_to(here.kind) && c.get(here) != c.get(there))
      all.push_back({c.name, readable(c, here), readable(c, there)});
  if (here.measures.snapshots != there.measures.snapshots)
    all.push_back({"snapshots", counted(std::ssize(here.measures.snapshots), "time"),
                   counted(std::ssize(there.measures.snapshots), "time")});
  if (here.kind == there.kind && composition_text(here) != composition_text(there)) {
    const std::string own = own_parts(here, there), other = own_parts(there, here);
    all.push_back({"composition", own, own == other ? "in another form" : other});
  }
  if (here.measures.gauges != there.measures.gauges) {
    const std::string own = own_of(here.measures.gauges, there.measures.gauges);
    const std::string other = own_of(there.measures.gauges, here.measures.gauges);
    all.push_back({"gauges", own, own == other ? "in another form" : other});
  }
  return all;
}

/// What a named material has a value for.
bool of_material(std::string_view name) {
  if (const auto* row = mpm::find_quantity(name)) return mpm::is_of_material(*row);
  const auto* row = mpm::find_choice(name);
  return row && row->section == mpm::Section::material;
}

/// Where the study says it: "studies/a.toml:12:16"; a value of a default says that.
std::string place_of(const std::optional<Wanted>& wanted, std::string_view name) {
  if (!wanted) return "";
  if (const auto& search = wanted->study.search; search && name == search->critical)
    return search->place + ", a round of the search";
  if (wanted->of_an_audit && name == "stop") return "--audit";
  if (name == "cell_size" && wanted->job.rung_of) return wanted->study.ladder_place;
  const auto& given = wanted->study.given;
  const auto found = std::ranges::find(given, name);
  if (found != given.end()) return wanted->study.places[static_cast<std::size_t>(found - given.begin())];
  // Two names for one freedom: the other one may be what the file says.
  if (const auto* row = mpm::find_quantity(name); row && !row->alternative.empty()) {
    const auto other = std::ranges::find(given, row->alternative);
    if (other != given.end()) return wanted->study.places[static_cast<std::size_t>(other - given.begin())];
  }
  if (const auto own = std::ranges::find(wanted->study.own, name, &OwnParameter::name);
      own != wanted->study.own.end())
    return own->place;
  if (name == "cell_size" && !wanted->study.ladder_place.empty()) return wanted->study.ladder_place;
  if (of_material(name) && !wanted->study.material_place.empty())
    return wanted->study.material_place + ", of the material";
  return "a default";
}

/// What tells the jobs of a study apart.
std::vector<std::string> own_parameters(const Study& study) {
  auto names = study.swept;
  if (study.search) names.push_back(study.search->critical);
  return names;
}

void print_own(const Wanted& wanted) {
  for (const auto& name : own_parameters(wanted.study))
    fmt::print("  {}  {}\n", label_of(wanted.job.scene, std::span(&name, 1)), place_of(wanted, name));
}

/// The job whose key begins so, among all that the study may ask for.
std::optional<Wanted> find_job(Study study, const std::string& key) {
  if (study.search) {
    const auto found = possible_scenes(study, [&](const std::string& own) { return own.starts_with(key); });
    if (found.empty()) return std::nullopt;
    const mpm::Scene& scene = found.front();
    const bool of_an_audit = std::ranges::none_of(
        study.scenes, [&](const mpm::Scene& point) { return point.measures.stop == scene.measures.stop; });
    return Wanted{std::move(study), {job_key(scene), scene, mpm::estimate(scene)}, of_an_audit};
  }
  for (const auto& job : all_jobs(make_plan(study)))
    if (job.key.starts_with(key)) return Wanted{std::move(study), job};
  return std::nullopt;
}

/// The job in the study files: those named, or those that the catalog has recorded.
std::optional<Wanted> find_in_files(const ExplainOptions& options, const std::string& key) {
  std::vector<std::pair<std::string, StudyOptions>> files;
  for (const auto& file : options.files)
    files.emplace_back(file, last_form(file, options.study, options.results).options);
  if (files.empty() && has_catalog(options.results))
    for (const auto& study : read_studies(options.results))
      if (auto form = recorded_form(study))
        files.emplace_back(std::move(form->path), std::move(form->options));
  for (const auto& [file, how] : files) {
    try {
      if (auto wanted = find_job(read_study(file, how), key)) return wanted;
    } catch (const StudyError&) {
      if (!options.files.empty()) throw;  // a file that is no longer valid says nothing about this job
    }
  }
  return std::nullopt;
}

void print_history(const std::string& results, const std::string& key) {
  fmt::print("history:\n");
  for (const JobEvent& event : events_of(results, key))
    fmt::print("  {}  {} by {}{}\n", event.at, event.from.empty() ? "new" : event.from + " -> " + event.to,
               event.by, event.reason.empty() ? "" : ": " + event.reason);
}

/// The studies that have the job, each with the reason that its planner gave.
void print_studies_of(const std::string& results, const std::string& key) {
  const auto decisions = decisions_of(results, key);
  if (decisions.empty()) fmt::print("of no study\n");
  for (const Decision& decision : decisions)
    fmt::print("of {}{}{}\n", decision.study, decision.reason.empty() ? "" : ": ", decision.reason);
}

/// What the next `run` does with the job.
std::string verdict(const StoredJob& job) {
  const int version = mpm::physics_version_of(job.job.scene);
  if (job.physics_version != version)
    return fmt::format(
        "made by physics version {}; this program has {} and another key for the same scene, so "
        "it is never reused",
        job.physics_version, version);
  switch (job.status) {
    case JobStatus::done:
      return "done: reused by every study that has it; it runs again only if a file of fields is damaged";
    case JobStatus::failed:
      return fmt::format("failed ({}) at step {}: {}\n  left so; `mpmstudy retry {}` plans it again",
                         job.failure_kind.empty() ? "error" : job.failure_kind, job.steps, job.reason,
                         short_key(job.job.key));
    case JobStatus::running:
      return "running (`mpmstudy status` says by whom); if that process has gone, a run of its study takes "
             "it up";
    case JobStatus::cancelled:
      return "cancelled: no study has it; it runs when one has it again";
    case JobStatus::planned:
      return "will run: it is not decided yet";
  }
  return "";
}

/// The job with the fewest other parameters among those that were there before.
const StoredJob* nearest_job(const std::vector<StoredJob>& all, const mpm::Scene& scene,
                             std::int64_t before) {
  const StoredJob* best = nullptr;
  std::size_t fewest = 0;
  for (const auto& other : all) {
    if (other.order >= before || other.job.scene.kind != scene.kind) continue;
    const auto count = changes(scene, other.job.scene).size();
    if (best && count >= fewest) continue;
    best = &other;
    fewest = count;
  }
  return best;
}

void print_news(const std::vector<StoredJob>& all, const mpm::Scene& scene, std::int64_t order,
                const std::optional<Wanted>& wanted) {
  const StoredJob* other = nearest_job(all, scene, order);
  if (!other) {
    fmt::print("its key was new: the catalog had no job of this kind\n");
    return;
  }
  const auto news = changes(scene, other->job.scene);
  if (news.empty()) {
    fmt::print("its key was new: the same scene, {}, was made by physics version {}\n",
               short_key(other->job.key), other->physics_version);
    return;
  }
  fmt::print("its key was new: of the jobs before it, {} is nearest, and differs in\n",
             short_key(other->job.key));
  for (const auto& change : news) {
    const auto place = place_of(wanted, change.name);
    fmt::print("  {} = {} (there {}){}\n", change.name, change.here, change.there,
               place.empty() ? "" : "  " + place);
  }
}

}  // namespace

void setup_explain(CLI::App& app) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App& verb = *app.add_subcommand("explain", "Say why a job ran or will run, or why it failed");
  verb.add_option("KEY", options->key, "Key of a job, or its first digits")->required();
  verb.add_option("STUDY", options->files, "Study files [those that were run]");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_explain(*options)); });
}

int run_explain(const ExplainOptions& said) {
  ExplainOptions options = said;
  // CSV ends its lines with carriage return and line feed; in a shell the first becomes part of the key.
  while (!options.key.empty() && std::isspace(static_cast<unsigned char>(options.key.back())))
    options.key.pop_back();
  const bool catalog = has_catalog(options.results);
  const auto all = catalog ? read_jobs(options.results) : std::vector<StoredJob>();
  const StoredJob* job = nullptr;
  for (const auto& one : all)
    if (one.job.key.starts_with(options.key)) {
      if (job) throw CatalogError(options.key + ": several jobs begin so; give more digits");
      job = &one;
    }
  const auto wanted = find_in_files(options, job ? job->job.key : options.key);
  if (!job && !wanted)
    throw CatalogError(options.key + ": neither the catalog nor " +
                       (options.files.empty() ? "a study that it knows" : "these studies") +
                       " has such a job; `mpmstudy plan STUDY` lists keys");
  const Job& it = job ? job->job : wanted->job;
  const auto own = wanted ? own_parameters(wanted->study) : std::vector<std::string>();
  fmt::print("{}  {}\n", it.key, label_of(it.scene, own));
  if (!job) {
    fmt::print("of {}\nwill run: the catalog does not have it\n", wanted->study.name);
    print_own(*wanted);
    print_news(all, it.scene, static_cast<std::int64_t>(all.size()) + 1, wanted);
    return exit_ok;
  }
  print_studies_of(options.results, it.key);
  fmt::print("{}\n", verdict(*job));
  if (job->crashes > 0)
    fmt::print("its process ended while it ran, {}, so it runs in a process of its own\n",
               job->crashes == 1 ? "once" : fmt::format("{} times", job->crashes));
  if (wanted) print_own(*wanted);
  print_news(all, it.scene, job->order, wanted);
  print_history(options.results, it.key);
  return exit_ok;
}

}  // namespace mpmstudy
