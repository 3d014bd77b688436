#include "runner/catalog/accuracy.hpp"

#include "runner/catalog/sql.hpp"

namespace mpmstudy {

std::vector<LadderValue> ladder_values(const std::filesystem::path& results, const std::string& study,
                                       const std::string& quantity) {
  const std::string sql =
      "SELECT key, rung_key, cell_size_m, quantity, value, unit, measuring_error FROM ladders WHERE study = "
      "?1 AND status = 'done' AND value IS NOT NULL";
  const Rows rows =
      quantity.empty() ? ask(results, sql, study) : ask(results, sql + " AND quantity = ?2", study, quantity);
  std::vector<LadderValue> values;
  for (const auto& row : rows.rows)
    if (const auto cell = number_of(row[2]), value = number_of(row[4]); cell && value)
      values.push_back({text_of(row[0]), text_of(row[1]), *cell, text_of(row[3]), *value, text_of(row[5]),
                        number_of(row[6])});
  return values;
}

std::vector<JobAccuracy> accuracies(const std::filesystem::path& results, const std::string& study,
                                    const std::string& quantity) {
  std::vector<JobAccuracy> jobs;
  for (const auto& row :
       ask(results,
           "SELECT j.key, a.reached FROM jobs j LEFT JOIN accuracy a ON a.key = j.key AND a.study = j.study "
           "AND a.quantity = ?2 WHERE j.study = ?1 ORDER BY j.position",
           study, quantity)
           .rows)
    jobs.push_back({text_of(row[0]), number_of(row[1]) == 1.0});
  return jobs;
}

std::optional<double> largest_relative_error(const std::filesystem::path& results, const std::string& study,
                                             const std::string& quantity) {
  return number_of(ask(results, "SELECT max(error / value) FROM accuracy WHERE study = ?1 AND quantity = ?2",
                       study, quantity)
                       .rows.at(0)
                       .at(0));
}

std::vector<std::string> studies_that_missed(const std::filesystem::path& results) {
  std::string sql = "SELECT study FROM accuracy WHERE reached = 0";
  // A catalog of an older program that is only read has no such view.
  if (!ask(results, "SELECT 1 FROM sqlite_master WHERE type = 'view' AND name = 'brackets'").rows.empty())
    sql += " UNION SELECT study FROM brackets WHERE lower IS NULL OR upper IS NULL";
  std::vector<std::string> studies;
  for (const auto& row : ask(results, sql).rows) studies.push_back(text_of(row[0]));
  return studies;
}

}  // namespace mpmstudy
