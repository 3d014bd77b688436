#include "runner/cli/plan.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/job_states.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/cli/ask.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/cli/print_defaults.hpp"
#include "runner/cli/print_search.hpp"
#include "runner/cli/skipped_points.hpp"
#include "runner/exec/processors.hpp"
#include "runner/plan/gauge_text.hpp"
#include "runner/plan/warnings.hpp"
#include "runner/status/label.hpp"
#include "runner/study/ladder.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

using Json = nlohmann::ordered_json;

std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  if (seconds < 2 * 3600) return fmt::format("{:.3g} min", seconds / 60);
  return fmt::format("{:.3g} h", seconds / 3600);
}

/// "1.2 CPU-hours (95 % interval: 0.9 to 1.6)".
std::string readable_cost(const Prediction& cost) {
  constexpr double hour = 3600;
  std::string text = fmt::format("{:.3g} CPU-hours", cost.seconds / hour);
  if (cost.interval)
    text += fmt::format(" (95 % interval: {:.3g} to {:.3g})", cost.interval->low / hour,
                        cost.interval->high / hour);
  return text;
}

std::string source_of(const CostModel& cost) {
  return cost.learnt_from() > 0 ? fmt::format("learnt from {} on this host",
                                              counted(static_cast<std::int64_t>(cost.learnt_from()), "job"))
                                : fmt::format("assumed: {:.3g} particle updates per second and core",
                                              assumed_updates_per_second);
}

double longest_job(const std::vector<Job>& jobs) {
  double longest = 0;
  for (const Job& job : jobs) longest = std::max(longest, job.predicted_seconds);
  return longest;
}

double largest_job(const std::vector<Job>& jobs) {
  double largest = 0;
  for (const Job& job : jobs) largest = std::max(largest, predicted_bytes(job.scene, job.estimate));
  return largest;
}

void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows[0].size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  for (const auto& row : rows) {
    std::string line = fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) line += fmt::format("  {:>{}}", row[i], widths[i]);
    fmt::print("{}\n", line);
  }
}

/// One line per rung, over all ladders: how many jobs, how large, what they cost.
void print_ladder(const Plan& plan) {
  if (plan.ladders.empty()) return;
  if (plan.ladder.accuracy)
    fmt::print(
        "\nAccuracy {:g} % of {}: every job starts with the first {} of these cells and gets finer ones "
        "until its "
        "interval is inside, {} at most\n",
        100 * *plan.ladder.accuracy, plan.ladder.quantity, first_cells, plan.ladder.cells);
  else
    fmt::print("\nEvery job runs with {} cells, for intervals; the table has the finest\n",
               plan.ladder.cells);
  std::vector<std::vector<std::string>> rows = {
      {"rung", "cell_size", "jobs", "particles", "steps", "predicted"}};
  for (int k = 0; k < plan.ladder.cells; ++k) {
    const auto rung = static_cast<std::size_t>(k);
    double finest = plan.ladders[0][rung].scene.numerics.cell_size, coarsest = finest, seconds = 0;
    std::int64_t particles = 0, steps = 0;
    for (const auto& ladder : plan.ladders) {
      const Job& job = ladder[rung];
      finest = std::min(finest, job.scene.numerics.cell_size);
      coarsest = std::max(coarsest, job.scene.numerics.cell_size);
      particles = std::max(particles, job.estimate.particles);
      steps = std::max(steps, job.estimate.steps);
      seconds += job.predicted_seconds;
    }
    const std::string cells = readable(coarsest, "m");
    rows.push_back(
        {fmt::format("{}{}", k + 1, plan.ladder.accuracy && k >= first_cells ? " (if needed)" : ""),
         finest == coarsest ? cells : readable(finest, "m") + " ... " + cells,
         std::to_string(plan.ladders.size()), std::to_string(particles), std::to_string(steps),
         duration(seconds)});
  }
  print_table(rows);
}

/// What the runs of a search are predicted to cost: a round waits for the one before.
struct SearchCost {
  SearchForecast forecast;
  Prediction cpu;
  double wall_s = 0;
};

SearchCost search_cost(const Study& study, const CostModel& cost, int workers) {
  SearchCost search{forecast_search(study), {}, 0};
  std::vector<Job> all;
  for (const auto& round : search.forecast.rounds) {
    std::vector<Job> jobs;
    for (const mpm::Scene& scene : round) {
      const mpm::Estimate estimate = mpm::estimate(scene);
      jobs.push_back({job_key(scene), scene, estimate, cost.seconds(estimate)});
    }
    search.wall_s += wall_seconds(jobs, workers);
    all.insert(all.end(), jobs.begin(), jobs.end());
  }
  search.cpu = total_cost(cost, all);
  return search;
}

/// How many runs a [surface] may add.
std::int64_t added_runs(const Study& study, const std::vector<Job>& first) {
  return std::max<std::int64_t>(0, study.surface->budget - std::ssize(first));
}

/// Of the design and of all that a [surface] may add, by the first of its places.
Prediction added_cost(const Study& study, const Plan& plan, std::vector<Job> first) {
  const auto added = std::min(added_runs(study, first), std::ssize(plan.candidates));
  first.insert(first.end(), plan.candidates.begin(), plan.candidates.begin() + added);
  return total_cost(plan.cost, first);
}

/// key -> status; nothing where the catalog cannot be read.
std::map<std::string, JobStatus> known_jobs(const std::string& results) {
  try {
    return job_states(results);
  } catch (const CatalogError&) {
    return {};
  }
}

/// How many jobs the catalog has as done; those that it has under a former key count.
std::size_t count_done(const std::vector<Job>& jobs, const std::map<std::string, JobStatus>& known) {
  const auto done = [&](const std::string& key) {
    const auto found = known.find(key);
    return found != known.end() && found->second == JobStatus::done;
  };
  return static_cast<std::size_t>(std::ranges::count_if(
      jobs, [&](const Job& job) { return done(job.key) || done(former_key(job.scene)); }));
}

void print_text(const Study& study, const Plan& plan, int workers, const std::string& results) {
  std::vector<std::vector<std::string>> rows = {{"job"}};
  rows[0].insert(rows[0].end(), study.swept.begin(), study.swept.end());
  rows[0].insert(rows[0].end(), {"particles", "steps", "predicted"});
  for (const Job& job : plan.jobs) {
    std::vector<std::string> row = {short_key(job.key)};
    for (const std::string& name : study.swept) row.push_back(readable_parameter(job.scene, name));
    row.push_back(std::to_string(job.estimate.particles));
    row.push_back(std::to_string(job.estimate.steps));
    row.push_back(duration(job.predicted_seconds));
    rows.push_back(std::move(row));
  }
  fmt::print("{}: {} ({})\n\n", study.name, study.title, mpm::to_string(study.kind));
  print_table(rows);
  const std::size_t same = study.scenes.size() - plan.jobs.size();
  print_ladder(plan);
  const auto first = first_jobs(plan), all = all_jobs(plan);
  const std::string coarser = first.size() == plan.jobs.size()
                                  ? ""
                                  : fmt::format(" and {} at coarser cells", first.size() - plan.jobs.size());
  fmt::print("\n{} job{}{}{}: {}, the longest job {}, {} on -j {}; {}\n", plan.jobs.size(),
             plan.jobs.size() == 1 ? "" : "s",
             same == 0 ? "" : fmt::format(" ({} more are the same as one of these)", same), coarser,
             readable_cost(total_cost(plan.cost, first)), duration(longest_job(first)),
             duration(wall_seconds(first, workers)), workers, source_of(plan.cost));
  const Demand demand = demand_of(first, workers);
  fmt::print("About {} of memory on -j {}, the largest job {}\n", readable_bytes(demand.bytes), workers,
             readable_bytes(largest_job(first)));
  if (const auto known = known_jobs(results); !known.empty())
    fmt::print("{} of {} done already in {}\n", count_done(first, known), first.size(), results);
  if (study.surface) {
    const SurfaceRequest& surface = *study.surface;
    fmt::print("[surface] of {} adds up to {} runs where they tell it most, {} in a round: {} for all {}\n",
               surface.of, added_runs(study, first), surface.batch,
               readable_cost(added_cost(study, plan, first)), surface.budget);
  } else if (all.size() > first.size())
    fmt::print("At most, if no ladder ends early: {} jobs, {}, {} on -j {}\n", all.size(),
               readable_cost(total_cost(plan.cost, all)), duration(wall_seconds(all, workers)), workers);
  if (study.search) {
    const SearchCost search = search_cost(study, plan.cost, workers);
    fmt::print(
        "\nThe jobs above, at the lower end of the search, stand for its points.\nA {}\nIn all {}, {} on -j "
        "{}\n",
        readable_forecast(study, search.forecast), readable_cost(search.cpu), duration(search.wall_s),
        workers);
  }
  if (const std::string skipped = skipped_text(study); !skipped.empty()) fmt::print("\n{}", skipped);
  print_defaults(study, plan);
}

Json to_json(const Study& study, const Plan& plan, int workers, const std::string& results) {
  const auto one = [&](const Job& job) {
    Json parameters;
    for (const mpm::Quantity& row : mpm::quantities())
      if (row.belongs_to(study.kind)) {
        const double value = row.get(job.scene);  // JSON has no infinite numbers
        parameters[std::string(row.column)] = std::isinf(value) ? Json("infinite") : Json(value);
      }
    for (const mpm::Choice& row : mpm::choices())
      if (row.belongs_to(study.kind)) parameters[std::string(row.column)] = row.allowed[row.get(job.scene)];
    parameters["snapshots_s"] = job.scene.measures.snapshots;
    if (!job.scene.measures.gauges.empty())
      parameters["gauges"] = Json::parse(gauges_text(job.scene.measures.gauges));
    Json own = Json::object();
    for (const mpm::Label& label : job.scene.labels)
      own[label.name] = {{"value", label.value}, {"unit", label.unit}};
    return Json{{"key", job.key},
                {"parameters", std::move(parameters)},
                {"own_parameters", std::move(own)},
                {"particles", job.estimate.particles},
                {"steps", job.estimate.steps},
                {"predicted_seconds", job.predicted_seconds},
                {"predicted_bytes", predicted_bytes(job.scene, job.estimate)}};
  };
  Json jobs = Json::array(), ladders = Json::array();
  for (const Job& job : plan.jobs) jobs.push_back(one(job));
  for (const auto& ladder : plan.ladders) {
    Json rungs = Json::array();
    for (const Job& rung : ladder) rungs.push_back(one(rung));
    ladders.push_back(std::move(rungs));
  }
  const auto first = first_jobs(plan);
  const Prediction cost = total_cost(plan.cost, first);
  Json search = nullptr;
  if (study.search) {
    const SearchCost predicted = search_cost(study, plan.cost, workers);
    search = {{"runs", predicted.forecast.runs},      {"fewest_runs", predicted.forecast.fewest},
              {"most_runs", predicted.forecast.most}, {"rounds", predicted.forecast.rounds.size()},
              {"cpu_seconds", predicted.cpu.seconds}, {"wall_seconds", predicted.wall_s}};
  }
  return {{"study", study.name},
          {"title", study.title},
          {"scene", mpm::to_string(study.kind)},
          {"swept", study.swept},
          {"jobs", std::move(jobs)},
          {"skipped", skipped_json(study)},
          {"ladders", std::move(ladders)},
          {"cpu_seconds", cost.seconds},
          {"cpu_seconds_low", cost.interval ? Json(cost.interval->low) : Json(nullptr)},
          {"cpu_seconds_high", cost.interval ? Json(cost.interval->high) : Json(nullptr)},
          {"longest_job_seconds", longest_job(first)},
          {"most_cpu_seconds",
           study.surface ? added_cost(study, plan, first).seconds : cpu_seconds(all_jobs(plan))},
          {"workers", workers},
          {"wall_seconds", wall_seconds(first, workers)},
          {"search", std::move(search)},
          {"memory_bytes", demand_of(first, workers).bytes},
          {"done_already", count_done(first, known_jobs(results))},
          {"warnings", warnings_of(study, plan)},
          {"learnt_from_jobs", plan.cost.learnt_from()}};
}

}  // namespace

void setup_plan(CLI::App& app) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App& verb = *app.add_subcommand("plan", "Print the jobs of a study and what they will cost");
  verb.add_option("FILE", options->file, "Study file")->required();
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.add_option("-j,--jobs", options->workers, "Worker threads to predict for [processors]")
      ->check(CLI::Range(1, 4096));
  verb.add_flag("--json", options->json, "One JSON object, SI units, full precision");
  verb.callback([options] { end_with(run_plan(*options)); });
}

int run_plan(const PlanOptions& options) {
  const int workers = options.workers > 0 ? options.workers : usable_processors();
  const Study study = read_study(options.file, options.study);
  say_last_form(study, options.study, options.results);
  const Plan plan = make_plan(study, CostModel(measured_costs(options.results)));
  if (options.json)
    fmt::print("{}\n", to_json(study, plan, workers, options.results).dump(2));
  else
    print_warnings(warnings_of(study, plan)), print_text(study, plan, workers, options.results);
  return exit_ok;
}

}  // namespace mpmstudy
