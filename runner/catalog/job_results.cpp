#include "runner/catalog/job_results.hpp"

#include <fmt/format.h>

#include "libmpm/measure/results.hpp"
#include "runner/catalog/sql.hpp"

namespace mpmstudy {

std::vector<DoneJob> done_jobs(const std::filesystem::path& results, const std::string& study) {
  std::vector<DoneJob> jobs;
  for (const auto& row :
       ask(results,
           "SELECT DISTINCT key, energy_error, final_area_m2, final_area_error_m2 FROM jobs "
           "WHERE study = ?1 AND status = 'done' ORDER BY key",
           study)
           .rows)
    jobs.push_back({text_of(row[0]), number_of(row[1]), number_of(row[2]), number_of(row[3])});
  return jobs;
}

std::string flags_of_job(const std::filesystem::path& results, const std::string& study,
                         const std::string& key) {
  const Rows rows = ask(results, "SELECT flags FROM jobs WHERE key = ?1 AND study = ?2 LIMIT 1", key, study);
  return rows.rows.empty() ? "" : text_of(rows.rows[0][0]);
}

JobResult result_of_job(const std::filesystem::path& results, const std::string& study,
                        const std::string& key, const std::string& name) {
  const mpm::ResultRow* known = mpm::find_result(name);
  Rows rows;
  if (known && known->column)
    rows = ask(results,
               fmt::format("SELECT {}, {} FROM jobs WHERE key = ?1 AND study = ?2", name,
                           known->error_column.empty() ? "NULL" : known->error_column),
               key, study);
  else
    rows = ask(results, "SELECT value, error FROM metrics WHERE key = ?1 AND name = ?2", key, name);
  if (rows.rows.empty()) return {};
  return {number_of(rows.rows[0][0]), number_of(rows.rows[0][1])};
}

std::string unit_of_metric(const std::filesystem::path& results, const std::string& name) {
  const Rows rows = ask(results, "SELECT unit FROM metrics WHERE name = ?1 LIMIT 1", name);
  return rows.rows.empty() ? "1" : text_of(rows.rows[0][0]);
}

mpm::History history_of_job(const std::filesystem::path& results, const std::string& key,
                            const std::string& gauge) {
  mpm::History history{gauge, "1", {}, {}};
  for (const auto& row : ask(results,
                             "SELECT time_s, value, unit FROM history WHERE key = ?1 AND name = ?2 "
                             "ORDER BY time_s",
                             key, gauge)
                             .rows) {
    history.times.push_back(number_of(row[0]).value_or(0));
    history.values.push_back(number_of(row[1]).value_or(0));
    history.unit = text_of(row[2]);
  }
  return history;
}

std::vector<mpm::AreaSample> area_history_of_job(const std::filesystem::path& results,
                                                 const std::string& key) {
  std::vector<mpm::AreaSample> history;
  for (const auto& row :
       ask(results, "SELECT time_s, area_m2, void_area_m2 FROM area_history WHERE key = ?1 ORDER BY time_s",
           key)
           .rows)
    history.push_back(
        {number_of(row[0]).value_or(0), number_of(row[1]).value_or(0), number_of(row[2]).value_or(0)});
  return history;
}

std::vector<std::string> snapshot_paths(const std::filesystem::path& results, const std::string& key) {
  std::vector<std::string> paths;
  for (const auto& row : ask(results, "SELECT path FROM snapshots WHERE key = ?1 ORDER BY time_s", key).rows)
    paths.push_back(text_of(row[0]));
  return paths;
}

std::vector<SnapshotFile> all_snapshots(const std::filesystem::path& results) {
  std::vector<SnapshotFile> files;
  for (const auto& row : ask(results, "SELECT path, bytes, checksum FROM snapshots ORDER BY path").rows)
    files.push_back({0, 0, text_of(row[0]), std::get<std::int64_t>(row[1]), text_of(row[2])});
  return files;
}

}  // namespace mpmstudy
