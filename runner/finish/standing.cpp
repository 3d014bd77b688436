#include "runner/finish/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/job_rows.hpp"
#include "runner/catalog/job_states.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/plan/plan.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

/// "impact_speed = 150 m/s" for every parameter whose values in the catalog are not those of the file; only
/// the physics, or only the numerics.
std::string differences(const Study& study, const std::filesystem::path& results, bool physics) {
  constexpr std::size_t most_values = 4;
  std::string text;
  for (const mpm::Quantity& q : mpm::quantities()) {
    const bool is_physics = q.section == mpm::Section::parameters || q.section == mpm::Section::material;
    if (q.derived || !q.belongs_to(study.kind) || is_physics != physics) continue;
    if (study.search && study.search->critical == q.name) continue;
    std::set<std::string> said, stored;
    for (const mpm::Scene& scene : study.scenes) said.insert(readable(q, scene));
    std::string values;
    for (const double number : parameter_values(results, study.name, std::string(q.name))) {
      mpm::Scene scene = study.scenes.front();
      q.set(scene, number);
      const std::string value = readable(q, scene);
      if (stored.insert(value).second && stored.size() <= most_values)
        values += (values.empty() ? "" : ", ") + value;
    }
    if (stored.empty() || stored == said) continue;
    text += fmt::format("{}{} = {}{}", text.empty() ? "" : "; ", q.name, values,
                        stored.size() > most_values ? ", ..." : "");
  }
  return text;
}

/// A value that stands twice in a list makes one job, or one point of a search.
std::size_t distinct_jobs(const Study& study) {
  std::set<std::string> keys;
  for (const mpm::Scene& scene : study.scenes) keys.insert(job_key(scene));
  return keys.size();
}

}  // namespace

StudyStanding standing_of(const Study& study, const std::filesystem::path& results) {
  const auto states = counts_of(results, study.name);
  std::size_t jobs = 0;
  for (const auto& [status, count] : states) jobs += count;
  if (jobs == 0) return {Standing::other, "the catalog does not have the study"};
  const StudyResults found = read_results(study, results);
  const bool others = !study.search && !study.surface && found.missing == 0 && jobs > found.done.size();
  const std::size_t wanted = distinct_jobs(study);
  const bool whole = found.missing == 0 && (!study.search || found.done.size() == wanted);
  if (whole && !others) return {};
  for (const bool physics : {true, false})
    if (const std::string text = differences(study, results, physics); !text.empty())
      return {Standing::other, "the catalog has it at " + text};
  if (others) return {Standing::other, "the catalog has other jobs under its name, too"};
  const auto count = [&](JobStatus status) { return states.contains(status) ? states.at(status) : 0; };
  const bool open = count(JobStatus::planned) + count(JobStatus::running) > 0;
  if (study.search)
    return {open || found.missing > 0 ? Standing::other : Standing::undecided,
            fmt::format("{} of {} points are bracketed", found.done.size(), wanted)};
  if (const auto failed = count(JobStatus::failed); failed > 0 && !open)
    return {Standing::undecided, fmt::format("{} of {} jobs failed", failed, wanted)};
  return {Standing::other, fmt::format("{} of {} jobs are done", found.done.size(), wanted)};
}

}  // namespace mpmstudy
