#include "runner/ladder/measured.hpp"

#include <cmath>

#include "runner/catalog/query.hpp"

namespace mpmstudy {

RungState recorded(const std::filesystem::path& results, const Job& job, const std::string& quantity) {
  const SqlValue parameters[] = {job.key, quantity};
  const Rows rows = query(results,
                          "SELECT j.status, CASE ?2 WHEN 'collapsibility' THEN j.collapsibility "
                          "WHEN 'final_area_m2' THEN j.final_area_m2 ELSE c.value END, "
                          "CASE ?2 WHEN 'collapsibility' THEN j.collapsibility_error "
                          "WHEN 'final_area_m2' THEN j.final_area_error_m2 ELSE c.error END FROM job j "
                          "LEFT JOIN metric c ON c.job_id = j.id AND c.name = ?2 WHERE j.key = ?1",
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
