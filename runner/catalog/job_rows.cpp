#include "runner/catalog/job_rows.hpp"

#include <fmt/format.h>

#include "libmpm/measure/results.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/sql.hpp"

namespace mpmstudy {
namespace {

bool is_column(const std::string& result) {
  const mpm::ResultRow* row = mpm::find_result(result);
  return row && row->column;
}

bool in_table(const std::string& parameter) {
  return mpm::find_quantity(parameter) || mpm::find_choice(parameter);
}

/// ", value, error" of a result, over `jobs j`: columns of the view, or a metric.
std::string columns_of_result(const std::string& name) {
  if (is_column(name)) {
    const std::string_view error = mpm::find_result(name)->error_column;
    return fmt::format(", j.{}, {}", name, error.empty() ? "NULL" : fmt::format("j.{}", error));
  }
  const auto of_metric = [&](const char* what) {
    return fmt::format(", (SELECT m.{} FROM metrics m WHERE m.key = j.key AND m.name = '{}')", what, name);
  };
  return of_metric("value") + of_metric("error");
}

std::string columns_of_parameters(const std::vector<std::string>& parameters, const std::string& study = "") {
  std::string columns;
  for (const auto& name : parameters) columns += ", " + sql_of_parameter(name, "j", study);
  return columns;
}

std::int64_t count_of(const Rows& rows) { return std::get<std::int64_t>(rows.rows.at(0).at(0)); }

}  // namespace

std::string column_of_parameter(const std::string& parameter) {
  if (const auto* quantity = mpm::find_quantity(parameter)) return std::string(quantity->column);
  if (const auto* choice = mpm::find_choice(parameter)) return std::string(choice->column);
  return parameter;  // of a study's own
}

std::string sql_of_parameter(const std::string& parameter, const std::string& jobs,
                             const std::string& study) {
  const auto* row = mpm::find_quantity(parameter);
  const bool of_all_kinds = mpm::find_choice(parameter) || (row && row->belongs_to.bits == ~0u);
  const std::string column =
      in_table(parameter) ? fmt::format("{}.\"{}\"", jobs, column_of_parameter(parameter)) : "NULL";
  if (of_all_kinds) return column;
  // a study whose kind has no such row may call its own so
  return fmt::format(
      "coalesce({}, (SELECT p.value FROM parameters p WHERE p.study = {} AND p.key = {}.key "
      "AND p.name = '{}')) AS \"{}\"",
      column, study.empty() ? jobs + ".study" : study, jobs, parameter, column_of_parameter(parameter));
}

std::vector<JobRow> job_rows(const std::filesystem::path& folder, const JobRequest& request) {
  std::string sql = "SELECT j.key, j.status, j.outcome, j.flags" + columns_of_parameters(request.parameters);
  for (const auto& name : request.results) sql += columns_of_result(name);
  sql += fmt::format(" FROM jobs j WHERE j.study = ?1{} ORDER BY j.position, j.key LIMIT {} OFFSET {}",
                     request.done_only ? " AND j.status = 'done'" : "", request.most, request.from);
  std::vector<JobRow> jobs;
  for (const auto& row : ask(folder, sql, request.study).rows) {
    JobRow job{text_of(row[0]), job_status_from(text_of(row[1])), text_of(row[2]), text_of(row[3]), {}, {}};
    std::size_t at = 4;
    for (std::size_t i = 0; i < request.parameters.size(); ++i) job.parameters.push_back(row[at++]);
    for (std::size_t i = 0; i < request.results.size(); ++i, at += 2)
      job.results.push_back({number_of(row[at]), number_of(row[at + 1])});
    jobs.push_back(std::move(job));
  }
  return jobs;
}

std::int64_t count_jobs(const std::filesystem::path& results, const std::string& study) {
  return count_of(ask(results, "SELECT count(*) FROM jobs WHERE study = ?1", study));
}

std::vector<FlagCount> flag_counts(const std::filesystem::path& results, const std::string& study) {
  std::vector<FlagCount> counts;
  for (const auto& row : ask(results,
                             "SELECT flags, count(*) FROM jobs WHERE study = ?1 AND status = 'done' AND "
                             "flags <> '' GROUP BY flags ORDER BY min(position)",
                             study)
                             .rows)
    counts.push_back({text_of(row[0]), std::get<std::int64_t>(row[1])});
  return counts;
}

std::string readable_sql(const JobRequest& request) {
  std::string columns = "key, status, outcome, flags";
  for (const auto& name : request.parameters)
    columns += ", " + (in_table(name) ? column_of_parameter(name) : sql_of_parameter(name, "jobs"));
  for (const auto& name : request.results) {
    if (!is_column(name)) continue;
    const std::string_view error = mpm::find_result(name)->error_column;
    columns += fmt::format(", {}{}{}", name, error.empty() ? "" : ", ", error);
  }
  return fmt::format("SELECT {} FROM jobs WHERE study = '{}' ORDER BY position", columns, request.study);
}

FailedJobs failed_jobs(const std::filesystem::path& results, const std::string& study,
                       const std::vector<std::string>& parameters, std::int64_t most) {
  // Of the tables: in the view `jobs` coarser cells have no study.
  const std::string failed =
      " FROM job j JOIN study_job m ON m.job_id = j.id JOIN study s ON s.id = m.study_id WHERE s.name = ?1 "
      "AND j.status = 'failed'";
  FailedJobs jobs;
  const std::string sql = fmt::format(
      "SELECT j.key, coalesce(j.failure_kind, 'error'), coalesce(j.reason, ''){}{} ORDER BY "
      "m.position, j.cell_size_m DESC, j.key LIMIT {}",
      columns_of_parameters(parameters, "s.name"), failed, most);
  for (const auto& row : ask(results, sql, study).rows)
    jobs.first.push_back({text_of(row[0]), text_of(row[1]), text_of(row[2]), {row.begin() + 3, row.end()}});
  if (!jobs.first.empty()) jobs.count = count_of(ask(results, "SELECT count(*)" + failed, study));
  return jobs;
}

std::string readable_sql_of_failed() { return "SELECT key, study, reason FROM jobs WHERE status = 'failed'"; }

std::vector<double> parameter_values(const std::filesystem::path& results, const std::string& study,
                                     const std::string& parameter) {
  const std::string sql =
      fmt::format("SELECT DISTINCT \"{0}\" FROM jobs WHERE study = ?1 AND \"{0}\" IS NOT NULL ORDER BY 1",
                  column_of_parameter(parameter));
  std::vector<double> values;
  for (const auto& row : ask(results, sql, study).rows)
    if (const auto value = number_of(row[0])) values.push_back(*value);
  return values;
}

}  // namespace mpmstudy
