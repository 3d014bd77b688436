#include "runner/cli/print_failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/query.hpp"
#include "runner/status/label.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

constexpr std::int64_t most_failures = 10;

/// Of a study ?1, coarser cells of its jobs too (the view `jobs` has these without a study).
constexpr const char* failed =
    " FROM job j JOIN study_job m ON m.job_id = j.id JOIN study s ON s.id = m.study_id WHERE s.name = ?1 AND "
    "j.status = 'failed'";

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

std::string column_of_jobs(const std::string& parameter) {
  const auto* quantity = mpm::find_quantity(parameter);
  return std::string(quantity ? quantity->column : mpm::find_choice(parameter)->column);
}

/// "impact_speed = 900 m/s, wall_thickness = 1 um"
std::string label(const std::vector<std::string>& names, const std::vector<SqlValue>& row,
                  std::size_t first) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto* number = std::get_if<double>(&row[first + i]);
    const auto* quantity = mpm::find_quantity(names[i]);
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", names[i],
                        number && quantity ? readable(*number, quantity->unit) : text_of(row[first + i]));
  }
  return text;
}

}  // namespace

std::string results_option(const std::filesystem::path& results) {
  return results == "results" ? "" : " --results '" + results.string() + "'";
}

std::string failures_text(const Study& study, const std::filesystem::path& results) {
  const SqlValue name = study.name;
  const auto parameters = std::span(&name, 1);
  const auto names = varied(study);
  std::string columns;
  for (const auto& one : names) columns += ", j.\"" + column_of_jobs(one) + "\"";
  const auto rows =
      query(
          results,
          fmt::format("SELECT j.key, coalesce(j.failure_kind, 'error'), coalesce(j.reason, ''){}{} ORDER BY "
                      "m.position, j.cell_size_m DESC, j.key LIMIT {}",
                      columns, failed, most_failures),
          parameters)
          .rows;
  if (rows.empty()) return "";
  std::string text;
  for (const auto& row : rows) {
    const std::string begin = fmt::format("  failed  {}  {}: ", short_key(text_of(row[0])), text_of(row[1]));
    const std::string varies = label(names, row, 3), end = varies.empty() ? "" : "  " + varies;
    const std::size_t rest = line_columns - columns_of(begin);
    const std::size_t room = std::max(least_reason, rest - std::min(rest, columns_of(end)));
    text += cut_text(begin + cut_text(first_line(text_of(row[2])), room) + end, line_columns) + "\n";
  }
  const auto all = std::get<std::int64_t>(
      query(results, std::string("SELECT count(*)") + failed, parameters).rows.at(0).at(0));
  if (all > most_failures)
    text += fmt::format(
        "  ... {} more failed; all: mpmstudy query{} \"SELECT key, study, reason FROM jobs WHERE status = "
        "'failed'\"\n",
        all - most_failures, results_option(results));
  return text + fmt::format(
                    "  `mpmstudy explain{} KEY` has the whole reason; `mpmstudy run --retry-failed` "
                    "runs failed jobs again\n",
                    results_option(results));
}

}  // namespace mpmstudy
