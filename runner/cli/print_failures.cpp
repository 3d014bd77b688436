#include "runner/cli/print_failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/job_rows.hpp"
#include "runner/status/label.hpp"
#include "runner/study/characters.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

constexpr std::int64_t most_failures = 10;

constexpr std::size_t least_reason = 40;  ///< columns of a reason that a label leaves

/// What sets jobs apart that are in no table: those of a search (the searched quantity first), and coarser
/// cells of a ladder.
std::vector<std::string> varied(const Study& study) {
  std::vector<std::string> names = study.swept;
  if (study.search)
    names.insert(names.begin(), study.search->critical);
  else if (study.ladder.cells > 1)
    names.emplace_back("cell_size");
  else
    names.clear();
  return names;
}

/// "impact_speed = 900 m/s, wall_thickness = 1 um"
std::string label(const std::vector<std::string>& names, const std::vector<SqlValue>& values) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto* number = std::get_if<double>(&values[i]);
    const auto* quantity = mpm::find_quantity(names[i]);
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", names[i],
                        number && quantity ? readable(*number, quantity->unit) : text_of(values[i]));
  }
  return text;
}

}  // namespace

std::string results_option(const std::filesystem::path& results) {
  return results == "results" ? "" : " --results '" + results.string() + "'";
}

std::string failures_text(const Study& study, const std::filesystem::path& results) {
  const auto names = varied(study);
  const FailedJobs failed = failed_jobs(results, study.name, names, most_failures);
  if (failed.first.empty()) return "";
  std::string text;
  for (const auto& job : failed.first) {
    const std::string begin = fmt::format("  failed  {}  {}: ", short_key(job.key), job.kind);
    const std::string varies = label(names, job.parameters), end = varies.empty() ? "" : "  " + varies;
    const std::size_t rest = line_columns - characters_in(begin);
    const std::size_t room = std::max(least_reason, rest - std::min(rest, characters_in(end)));
    text += cut_text(begin + cut_text(first_line(job.reason), room) + end, line_columns) + "\n";
  }
  if (failed.count > most_failures)
    text += fmt::format("  ... {} more failed; all: mpmstudy query{} \"{}\"\n", failed.count - most_failures,
                        results_option(results), readable_sql_of_failed());
  return text + fmt::format(
                    "  `mpmstudy explain{} KEY` has the whole reason; `mpmstudy run --retry-failed` "
                    "runs failed jobs again\n",
                    results_option(results));
}

}  // namespace mpmstudy
