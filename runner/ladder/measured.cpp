#include "runner/ladder/measured.hpp"

#include <cmath>

#include "runner/catalog/query.hpp"

namespace mpmstudy {

RungState recorded(const std::filesystem::path& results, const Job& job, const std::string& quantity) {
  const SqlValue parameters[] = {job.key, quantity};
  const Rows rows = query(results,
                          "SELECT j.status, l.value, l.measuring_error FROM jobs j LEFT JOIN ladders l "
                          "ON l.rung_key = j.key AND l.quantity = ?2 WHERE j.key = ?1 LIMIT 1",
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
