#include "runner/catalog/job_states.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/sql.hpp"

namespace mpmstudy {

std::map<std::string, JobStatus> job_states(const std::filesystem::path& results) {
  std::map<std::string, JobStatus> states;
  if (!has_catalog(results)) return states;
  for (const auto& row : ask(results, "SELECT key, status FROM job").rows)
    states.emplace(text_of(row[0]), job_status_from(text_of(row[1])));
  return states;
}

std::map<JobStatus, std::int64_t> counts_of(const std::filesystem::path& results, const std::string& study) {
  std::map<JobStatus, std::int64_t> counts;
  for (const auto& row :
       ask(results, "SELECT status, count(*) FROM jobs WHERE study = ?1 GROUP BY status", study).rows)
    counts[job_status_from(text_of(row[0]))] = std::get<std::int64_t>(row[1]);
  return counts;
}

std::vector<std::string> keys_of(const std::filesystem::path& results, const std::string& study,
                                 JobStatus status) {
  std::vector<std::string> keys;
  for (const auto& row :
       ask(results, "SELECT key FROM jobs WHERE study = ?1 AND status = ?2 ORDER BY position", study,
           std::string(to_string(status)))
           .rows)
    keys.push_back(text_of(row[0]));
  return keys;
}

std::vector<Decision> decisions_of(const std::filesystem::path& results, const std::string& key) {
  // not of the view: an older catalog that is only read has none
  const auto db = open_for_reading(results);
  const bool kept =
      db->execAndGet("SELECT count(*) FROM pragma_table_info('study_job') WHERE name = 'reason'").getInt() >
      0;
  std::vector<Decision> decisions;
  for (const auto& row :
       ask(results,
           std::string("SELECT s.name, ") + (kept ? "m.reason" : "NULL") +
               " FROM study_job m JOIN study s ON s.id = m.study_id JOIN job j ON j.id = m.job_id WHERE "
               "j.key = ?1 ORDER BY s.name",
           key)
           .rows)
    decisions.push_back({text_of(row[0]), text_of(row[1])});
  return decisions;
}

std::vector<JobEvent> events_of(const std::filesystem::path& results, const std::string& key) {
  std::vector<JobEvent> events;
  for (const auto& row :
       ask(results,
           "SELECT at, from_status, to_status, \"by\", reason FROM events WHERE key = ?1 ORDER BY id", key)
           .rows)
    events.push_back({text_of(row[0]), text_of(row[1]), text_of(row[2]), text_of(row[3]), text_of(row[4])});
  return events;
}

}  // namespace mpmstudy
