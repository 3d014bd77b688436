#include "runner/finish/study_results.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/units.hpp"
#include "libmpm/measure/results.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/found_values.hpp"
#include "runner/catalog/job_results.hpp"
#include "runner/finish/labels.hpp"
#include "runner/plan/plan.hpp"
#include "runner/status/label.hpp"
#include "runner/study/decimal.hpp"
#include "runner/study/gauges.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/searched.hpp"
#include "runner/study/written_unit.hpp"

namespace mpmstudy {
namespace {

bool differs_by_rounding(double a, double b) {
  constexpr double rounding = 1e-12;  // values of a study are written with twelve digits at most
  return a == b || std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));  // infinite ones, too
}

/// What jobs have of one swept name: for each job which value, as a number, in JSON, and as a label.
struct SweptValues {
  std::vector<std::size_t> which;   ///< of each job; equal: the same value
  std::vector<std::string> labels;  ///< of each job
  std::vector<nlohmann::json> json;
  std::string column;
};

SweptValues swept_values(const Study& study, const std::string& name, const std::vector<JobResults>& jobs) {
  SweptValues swept;
  if (const mpm::Choice* c = mpm::find_choice(name)) {
    swept.column = c->column;
    for (const JobResults& job : jobs) {
      swept.which.push_back(c->get(job.scene));
      swept.labels.emplace_back(c->allowed[swept.which.back()]);
      swept.json.push_back(swept.labels.back());
    }
    return swept;
  }
  const mpm::Quantity* q = mpm::find_quantity(name);
  swept.column = q ? q->column : name;
  std::vector<double> distinct, values;
  for (const JobResults& job : jobs) {
    const double value = quantity_value(job.scene, name).value_or(0);
    const auto same =
        std::ranges::find_if(distinct, [&](double other) { return differs_by_rounding(value, other); });
    swept.which.push_back(static_cast<std::size_t>(same - distinct.begin()));
    if (same == distinct.end()) distinct.push_back(value);
    values.push_back(distinct[swept.which.back()]);
    swept.json.push_back(without_rounding(values.back()));
  }
  const auto written = study.units.find(name);
  if (!q && written != study.units.end() && quantity_unit(study, name) == "1")  // an angle in degrees
    for (const double value : values) swept.labels.push_back(name + " = " + in_unit(value, written->second));
  else
    swept.labels = analysis::value_labels(label_of_parameter(study, name), values);
  return swept;
}

/// The key of the run at an end of a bracket; "" if there is no end.
std::string key_at(mpm::Scene scene, const Searched& critical, std::optional<double> end) {
  if (!end) return "";
  critical.set(scene, *end);
  return job_key(scene);
}

/// Of a study with [search]: one entry for each bracket that its own runs prove. The scene is that of the
/// point. Rows of an earlier form of the study have other keys at their ends and are left out.
StudyResults read_brackets(const Study& study, const std::filesystem::path& folder) {
  StudyResults results{study.name, folder, {}, 0, {}};
  std::set<std::string> points;  // a value that the sweep has twice is searched once
  for (const mpm::Scene& scene : study.scenes) points.insert(job_key(scene));
  results.missing = points.size();
  const Searched critical(study);
  results.critical = &critical.quantity();
  std::string drawn;
  for (const BracketRow& row : brackets_of(folder, study.name, study.search->critical)) {
    const auto position = static_cast<std::size_t>(row.position);
    if (position >= study.scenes.size()) continue;
    const mpm::Scene& scene = study.scenes[position];
    const auto lower = row.lower, upper = row.upper;
    if (key_at(scene, critical, lower) != row.lower_key || key_at(scene, critical, upper) != row.upper_key)
      continue;
    --results.missing;
    drawn += fmt::format("{} {} {:a} {:a} ", row.upper_key, row.flags, lower.value_or(0), upper.value_or(0));
    if (!lower || !upper) continue;  // looked for and not found
    JobResults job{row.upper_key,
                   scene,
                   ValueWithError{0.5 * (*lower + *upper), 0.5 * (*upper - *lower)},
                   {},
                   row.flags};
    if (row.extrapolated) job.extrapolated = ValueWithError{*row.extrapolated, row.interval};
    results.done.push_back(std::move(job));
  }
  results.fingerprint = fmt::format("{:016x}", XXH3_64bits(drawn.data(), drawn.size()));
  return results;
}

/// Why the final area of a job has no meaning; "": it has one.
std::string flags_of(const StudyResults& results, const JobResults& job) {
  return flags_of_job(results.folder, results.study, job.key);
}

/// What the fits and figures of a study are made of.
std::set<std::string> results_asked_for(const Study& study) {
  std::set<std::string> asked;
  for (const FitRequest& fit : study.fits) asked.insert(fit.y);
  for (const FigureRequest& figure : study.figures) asked.insert({figure.x, figure.y, figure.colour});
  return asked;
}

/// What the flags of a bracket say where it is doubtful (search/bracket.cpp).
constexpr const char* doubts[] = {"flips back at", "lower end undecided"};

/// Brackets that fits and figures are made of and that have flags, a line each.
std::vector<std::string> lines_of_brackets(const Study& study, const StudyResults& results, bool doubtful) {
  std::vector<std::string> lines;
  if (std::ranges::none_of(results_asked_for(study),
                           [](const std::string& name) { return critical_result(name).has_value(); }))
    return lines;
  for (const JobResults& bracket : results.done) {
    if (bracket.flags.empty() || is_doubtful(bracket.flags) != doubtful) continue;
    const std::string point = label_of(bracket.scene, study.swept);
    lines.push_back(fmt::format("{} of the bracket{}{}: {}", results.critical->name,
                                point.empty() ? "" : " at ", point, bracket.flags));
  }
  return lines;
}

}  // namespace

bool is_of_the_final_area(const std::string& name) {
  const mpm::ResultRow* row = mpm::find_result(name);
  return row && row->of_closed_cavity;
}

bool is_doubtful(const std::string& flags) {
  return std::ranges::any_of(doubts,
                             [&](const char* doubt) { return flags.find(doubt) != std::string::npos; });
}

StudyResults read_results(const Study& study, const std::filesystem::path& folder) {
  if (study.search) return read_brackets(study, folder);
  StudyResults results{study.name, folder, {}, 0, {}};
  std::set<std::string> done;
  std::string drawn;
  const auto jobs = done_jobs(folder, study.name);
  for (const DoneJob& job : jobs) done.insert(job.key);
  std::set<std::string> seen;
  for (const mpm::Scene& scene : study.scenes) {
    if (!seen.insert(job_key(scene)).second) continue;  // a value that stands twice in a list counts once
    // With an accuracy it is the finest cell that the ladder has reached.
    const LadderScenes ladder = ladder_scenes(scene, study.ladder);
    auto rung = ladder.scenes.size();
    std::string key;
    do {
      key = job_key(ladder.scenes[--rung]);
    } while (!done.contains(key) && rung > ladder.first_answer);
    if (!done.contains(key)) {
      ++results.missing;
      continue;
    }
    results.done.push_back({key, ladder.scenes[rung], {}, {}, {}});
    drawn += key;
  }
  if (study.surface)  // what its [surface] has added, of all that it may add
    for (const mpm::Scene& scene : study.surface->candidates) {
      const std::string key = job_key(scene);
      if (!done.contains(key) || !seen.insert(key).second) continue;
      results.done.push_back({key, scene, {}, {}, {}});
      drawn += key;
    }
  for (const DoneJob& job : jobs)
    for (const auto& value : {job.energy_error, job.final_area, job.final_area_error})
      if (value) drawn += fmt::format(" {:a}", *value);
  results.fingerprint = fmt::format("{:016x}", XXH3_64bits(drawn.data(), drawn.size()));
  return results;
}

std::optional<ValueWithError> result_of(const StudyResults& results, const JobResults& job,
                                        const std::string& name) {
  if (const auto critical = critical_result(name)) {
    if (is_doubtful(job.flags)) return std::nullopt;
    return critical == CriticalResult::bracket ? job.critical : job.extrapolated;
  }
  if (is_of_the_final_area(name) && !flags_of(results, job).empty()) return std::nullopt;
  const JobResult result = result_of_job(results.folder, results.study, job.key, name);
  if (!result.value) return std::nullopt;
  return ValueWithError{*result.value, result.error};
}

std::string unit_of(const StudyResults& results, const std::string& name) {
  if (results.critical && critical_result(name)) return std::string(results.critical->unit);
  if (const mpm::ResultRow* row = mpm::find_result(name))
    return row->column ? analysis::with_powers(row->unit) : std::string(row->unit);
  std::vector<const mpm::Scene*> scenes;
  for (const JobResults& job : results.done) scenes.push_back(&job.scene);
  const std::string of_gauge = unit_of_gauge(scenes, name);
  return of_gauge.empty() ? unit_of_metric(results.folder, name) : of_gauge;
}

mpm::History history_of(const StudyResults& results, const JobResults& job, const std::string& gauge) {
  return history_of_job(results.folder, job.key, gauge);
}

std::vector<mpm::AreaSample> area_history_of(const StudyResults& results, const JobResults& job) {
  return area_history_of_job(results.folder, job.key);
}

std::vector<std::filesystem::path> snapshots_of(const StudyResults& results, const JobResults& job) {
  std::vector<std::filesystem::path> files;
  for (const auto& path : snapshot_paths(results.folder, job.key)) files.push_back(results.folder / path);
  return files;
}

std::vector<Group> group_jobs(const Study& study, const StudyResults& results,
                              const std::vector<std::string>& within) {
  std::vector<SweptValues> swept;
  for (const std::string& name : study.swept)
    if (std::ranges::find(within, name) == within.end())
      swept.push_back(swept_values(study, name, results.done));
  std::vector<Group> groups;
  std::map<std::vector<std::size_t>, std::size_t> known;  // values -> group
  for (std::size_t i = 0; i < results.done.size(); ++i) {
    std::vector<std::size_t> values;
    for (const SweptValues& one : swept) values.push_back(one.which[i]);
    const auto [at, is_new] = known.emplace(std::move(values), groups.size());
    if (is_new) {
      Group group;
      nlohmann::ordered_json family = nlohmann::ordered_json::object();
      for (const SweptValues& one : swept) {
        group.label += (group.label.empty() ? "" : ", ") + one.labels[i];
        family[one.column] = one.json[i];
      }
      group.family = family.dump();
      groups.push_back(std::move(group));
    }
    groups[at->second].jobs.push_back(&results.done[i]);
  }
  return groups;
}

std::vector<std::string> left_out(const Study& study, const StudyResults& results) {
  const std::set<std::string> asked = results_asked_for(study);
  std::vector<std::string> lines = lines_of_brackets(study, results, true);
  for (const mpm::ResultRow& row : mpm::results()) {
    if (!row.of_closed_cavity || !asked.contains(std::string(row.name))) continue;
    for (const JobResults& job : results.done)
      if (const std::string flags = flags_of(results, job); !flags.empty())
        lines.push_back(fmt::format("{} of job {}: {}", row.name, short_key(job.key), flags));
  }
  return lines;
}

std::vector<std::string> flagged_brackets(const Study& study, const StudyResults& results) {
  return lines_of_brackets(study, results, false);
}

std::vector<std::string> curve_of(const Study& study, const std::string& x, const std::string& y) {
  if (quantity_unit(study, x).empty()) return study.swept;  // a result against another one
  std::set<double> places;
  std::set<std::string> jobs;  // a value that stands twice in a list makes one job
  for (const mpm::Scene& scene : study.scenes) {
    places.insert(quantity_value(scene, x).value_or(0));
    jobs.insert(job_key(scene));
  }
  if (places.size() == jobs.size()) return study.swept;
  if (critical_result(y) == CriticalResult::extrapolated) return {x, "cell_size"};
  for (const auto& group : study.together) {
    if (std::ranges::find(group, x) == group.end()) continue;
    std::set<std::vector<double>> values;
    for (const mpm::Scene& scene : study.scenes) {
      std::vector<double> one;
      for (const std::string& name : group) one.push_back(parameter_number(scene, name));
      values.insert(std::move(one));
    }
    if (values.size() == places.size()) return group;
  }
  return {x};
}

std::vector<std::string> map_of(const Study& study, const std::string& x, const std::string& y) {
  std::vector<std::string> names = {x, y};
  for (const auto& group : study.together)
    if (std::ranges::find(group, x) != group.end() || std::ranges::find(group, y) != group.end())
      names.insert(names.end(), group.begin(), group.end());
  return names;
}

}  // namespace mpmstudy
