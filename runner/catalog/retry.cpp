// Failed jobs are planned again when somebody asks.
#include "runner/catalog/store_impl.hpp"

namespace mpmstudy {

std::vector<std::string> Store::retry(const RetryFilter& filter) {
  SQLite::Statement rows(
      *impl_->db,
      "SELECT id, attempt, key FROM job WHERE status = 'failed' AND key >= ?1 AND key < ?2 "
      "AND (?3 = '' OR failure_kind = ?3) AND (?4 = '' OR EXISTS (SELECT 1 FROM study_job m "
      "JOIN study s ON s.id = m.study_id WHERE m.job_id = job.id AND s.name = ?4)) ORDER BY id");
  rows.bind(1, filter.key_begins);
  rows.bind(2, filter.key_begins + "g");  // behind every hexadecimal digit
  rows.bind(3, filter.kind);
  rows.bind(4, filter.study);
  std::vector<std::tuple<std::int64_t, std::int64_t, std::string>> jobs;
  while (rows.executeStep())
    jobs.emplace_back(rows.getColumn(0).getInt64(), rows.getColumn(1).getInt64(),
                      rows.getColumn(2).getString());
  std::vector<std::string> keys;
  for (const auto& [id, attempt, key] : jobs) {
    execute(impl_->plan_again, id);
    impl_->record(id, JobStatus::failed, JobStatus::planned, attempt, "retry asked for");
    keys.push_back(key);
  }
  return keys;
}

}  // namespace mpmstudy
