#include "runner/finish/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/query.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/plan/plan.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

Rows ask(const std::filesystem::path& results, const std::string& sql, const std::string& study) {
  const SqlValue name = study;
  return query(results, sql, std::span(&name, 1));
}

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
    const Rows rows = ask(results,
                          fmt::format("SELECT DISTINCT \"{0}\" FROM jobs WHERE study = ?1 AND \"{0}\" IS NOT "
                                      "NULL ORDER BY 1",
                                      q.column),
                          study.name);
    std::string values;
    for (const auto& row : rows.rows) {
      mpm::Scene scene = study.scenes.front();
      if (const auto* value = std::get_if<double>(&row[0])) q.set(scene, *value);
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
  const Rows states = ask(results, "SELECT status, key FROM jobs WHERE study = ?1", study.name);
  if (states.rows.empty()) return {Standing::other, "the catalog does not have the study"};
  const StudyResults found = read_results(study, results);
  const bool others = !study.search && found.missing == 0 && states.rows.size() > found.done.size();
  const std::size_t wanted = distinct_jobs(study);
  const bool whole = found.missing == 0 && (!study.search || found.done.size() == wanted);
  if (whole && !others) return {};
  for (const bool physics : {true, false})
    if (const std::string text = differences(study, results, physics); !text.empty())
      return {Standing::other, "the catalog has it at " + text};
  if (others) return {Standing::other, "the catalog has other jobs under its name, too"};
  const auto count = [&](const char* status) {
    return std::ranges::count_if(states.rows, [&](const auto& row) { return row[0] == SqlValue(status); });
  };
  const bool open = count("planned") + count("running") > 0;
  if (study.search)
    return {open || found.missing > 0 ? Standing::other : Standing::undecided,
            fmt::format("{} of {} points are bracketed", found.done.size(), wanted)};
  if (const auto failed = count("failed"); failed > 0 && !open)
    return {Standing::undecided, fmt::format("{} of {} jobs failed", failed, wanted)};
  return {Standing::other, fmt::format("{} of {} jobs are done", found.done.size(), wanted)};
}

}  // namespace mpmstudy
