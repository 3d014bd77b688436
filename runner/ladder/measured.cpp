#include "runner/ladder/measured.hpp"

#include <cmath>

#include "libmpm/measure/results.hpp"
#include "runner/catalog/query.hpp"

namespace mpmstudy {

RungState recorded(const std::filesystem::path& results, const Job& job, const std::string& quantity) {
  const SqlValue parameters[] = {job.key, quantity};
  const mpm::ResultRow* known = mpm::find_result(quantity);
  const bool column = known && !known->error_column.empty();
  const std::string value_sql = column ? "j." + quantity : "c.value";
  const std::string error_sql = column ? "j." + std::string(known->error_column) : "c.error";
  const Rows rows =
      query(results,
            "SELECT j.status, " + value_sql + ", " + error_sql +
                " FROM job j LEFT JOIN metric c ON c.job_id = j.id AND c.name = ?2 WHERE j.key = ?1",
            parameters);
  if (rows.rows.empty()) return {};
  const auto& row = rows.rows[0];
  const std::string& status = std::get<std::string>(row[0]);
  const auto* value = std::get_if<double>(&row[1]);
  const auto* error = std::get_if<double>(&row[2]);
  RungState rung{status == "done" || status == "failed", {}};
  if (status == "done" && value && std::isfinite(*value))
    rung.point = {job.scene.numerics.cell_size, *value,
                  error && std::isfinite(*error) ? std::abs(*error) : 0};
  return rung;
}

}  // namespace mpmstudy
