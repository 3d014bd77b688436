#include "runner/catalog/study_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runner/catalog/sql.hpp"

namespace mpmstudy {
namespace {

/// Name of a last column that is no part of the table: the key of the row's job.
constexpr const char* whole_key = "whole_key";

StudyTable table_of(Rows rows) {
  StudyTable table{std::move(rows.names), {}};
  const bool by_key = !table.head.empty() && table.head.back() == whole_key;
  if (by_key) table.head.pop_back();
  for (auto& row : rows.rows) {
    std::string key = by_key ? text_of(row.back()) : "";
    row.resize(table.head.size());
    table.rows.push_back({std::move(key), std::move(row)});
  }
  return table;
}

std::string columns_of(const std::vector<std::string>& parameters) {
  std::string columns;
  for (const std::string& name : parameters) columns += sql_of_parameter(name, "j") + ", ";
  return columns;
}

}  // namespace

StudyTable table_of_jobs(const std::filesystem::path& results, const std::string& study,
                         const std::vector<std::string>& parameters) {
  return table_of(ask(
      results,
      "SELECT " + columns_of(parameters) +
          "status, outcome, collapsibility, collapsibility_error, energy_error, particles, steps, cpu_s, "
          "flags, substr(key, 1, 12) AS job, key AS whole_key FROM jobs j WHERE study = ?1 ORDER BY position",
      study));
}

StudyTable table_of_metrics(const std::filesystem::path& results, const std::string& study) {
  return table_of(
      ask(results,
          "SELECT substr(j.key, 1, 12) AS job, m.name, m.value, m.error, m.unit, j.key AS whole_key FROM "
          "jobs j JOIN metrics m USING (key) WHERE j.study = ?1 ORDER BY j.position, m.name",
          study));
}

StudyTable table_of_accuracy(const std::filesystem::path& results, const std::string& study,
                             const std::vector<std::string>& parameters, const std::string& quantity) {
  return table_of(
      ask(results,
          "SELECT " + columns_of(parameters) +
              "a.value, a.error, a.extrapolated_value, a.extrapolated_error, a.observed_order, a.method, "
              "substr(a.key, 1, 12) AS job, a.key AS whole_key FROM accuracy a JOIN jobs j ON j.key = a.key "
              "AND j.study = a.study WHERE a.study = ?1 AND a.quantity = ?2 ORDER BY j.position",
          study, quantity));
}

StudyTable table_of_brackets(const std::filesystem::path& results, const std::string& study,
                             const std::vector<std::string>& parameters) {
  std::string swept;
  for (const std::string& name : parameters)
    if (name != "cell_size") swept += fmt::format("swept ->> '{0}' AS \"{0}\", ", column_of_parameter(name));
  return table_of(
      ask(results,
          "SELECT " + swept +
              "cell_size_m, quantity, unit, lower, upper, extrapolated, interval, runs, flags, "
              "substr(lower_key, 1, 12) AS lower_job, substr(upper_key, 1, 12) AS upper_job FROM brackets "
              "WHERE study = ?1 ORDER BY position",
          study));
}

StudyTable table_of_audit(const std::filesystem::path& results, const std::string& study,
                          const std::vector<std::string>& parameters) {
  std::string same;
  std::vector<std::string> columns;
  for (const std::string& name : parameters) {
    const std::string column = column_of_parameter(name);
    columns.push_back("a." + column);
    same += fmt::format(" AND a.{0} IS e.{0}", column);
  }
  return table_of(
      ask(results,
          fmt::format("SELECT {0}, e.outcome AS stopped_early, a.outcome AS run_to_end, substr(a.key, 1, 12) "
                      "AS job FROM jobs a JOIN jobs e ON e.study = ?1 AND a.study = e.study || '-audit'{1} "
                      "ORDER BY {0}",
                      fmt::join(columns, ", "), same),
          study));
}

StudyTable table_of_costs(const std::filesystem::path& results) {
  return table_of(ask(
      results,
      "SELECT study, count(*) AS jobs, sum(cpu_s) AS cpu_s, sum(CAST(particles AS REAL) * steps) AS "
      "particle_updates, avg(particle_updates_per_s) AS particle_updates_per_s, max(energy_error) AS "
      "largest_energy_error FROM jobs WHERE study IS NOT NULL AND status = 'done' GROUP BY study ORDER BY "
      "study"));
}

}  // namespace mpmstudy
