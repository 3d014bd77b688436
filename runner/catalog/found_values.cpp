#include "runner/catalog/found_values.hpp"

#include <fmt/format.h>

#include <limits>

#include "runner/catalog/sql.hpp"

namespace mpmstudy {

std::vector<BracketRow> brackets_of(const std::filesystem::path& results, const std::string& study,
                                    const std::string& quantity) {
  std::vector<BracketRow> brackets;
  for (const auto& row :
       ask(results,
           // The table, not the view: that one has rounded ends.
           "SELECT position, exact_lower, exact_upper, lower_key, upper_key, extrapolated, interval, flags "
           "FROM bracket WHERE study_id = (SELECT id FROM study WHERE name = ?1) AND quantity = ?2 "
           "ORDER BY position",
           study, quantity)
           .rows) {
    BracketRow bracket;
    bracket.quantity = quantity;
    bracket.position = std::get<std::int64_t>(row[0]);
    bracket.lower = number_of(row[1]);
    bracket.upper = number_of(row[2]);
    bracket.lower_key = text_of(row[3]);
    bracket.upper_key = text_of(row[4]);
    bracket.extrapolated = number_of(row[5]);
    bracket.interval = number_of(row[6]);
    bracket.flags = text_of(row[7]);
    brackets.push_back(std::move(bracket));
  }
  return brackets;
}

std::vector<CriticalSpeed> critical_speeds(const std::filesystem::path& results, const std::string& study,
                                           const std::string& parameter) {
  const std::string sql = fmt::format(
      "SELECT c.wall_thickness_m, c.cell_size_m, c.lower_m_s, c.upper_m_s, c.extrapolated_m_s, "
      "c.interval_m_s, c.flags, j.key IS NOT NULL, j.\"{}\" FROM critical_speed c LEFT JOIN jobs j ON j.key "
      "= c.upper_key AND j.study = c.study WHERE c.study = ?1 AND c.wall_thickness_m IS NOT NULL "
      "ORDER BY c.wall_thickness_m",
      column_of_parameter(parameter));
  std::vector<CriticalSpeed> speeds;
  for (const auto& row : ask(results, sql, study).rows)
    speeds.push_back({std::get<double>(row[0]), std::get<double>(row[1]), number_of(row[2]),
                      number_of(row[3]), number_of(row[4]), number_of(row[5]), text_of(row[6]),
                      number_of(row[7]) == 1.0, number_of(row[8])});
  return speeds;
}

std::vector<FitRow> fits_of(const std::filesystem::path& results, const std::string& study,
                            const std::string& quantity) {
  std::vector<FitRow> fits;
  for (const auto& row : ask(results,
                             "SELECT against, model, coefficient, value, standard_error, r2, unit, "
                             "reduced_chi2, points, family FROM fits WHERE study = ?1 AND quantity = ?2",
                             study, quantity)
                             .rows) {
    FitRow fit;
    fit.quantity = quantity;
    fit.against = text_of(row[0]);
    fit.model = text_of(row[1]);
    fit.coefficient = text_of(row[2]);
    fit.value = number_of(row[3]).value_or(std::numeric_limits<double>::quiet_NaN());
    fit.standard_error = number_of(row[4]);
    fit.r2 = number_of(row[5]);
    fit.unit = text_of(row[6]);
    fit.reduced_chi2 = number_of(row[7]);
    fit.points = static_cast<std::int64_t>(number_of(row[8]).value_or(0));
    fit.family = text_of(row[9]);
    fits.push_back(std::move(fit));
  }
  return fits;
}

}  // namespace mpmstudy
