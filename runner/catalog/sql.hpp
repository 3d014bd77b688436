#pragma once
/// What the typed answers of this folder are made with. SQL stands in this folder alone.
#include <array>
#include <filesystem>
#include <string>

#include "runner/catalog/query.hpp"

namespace mpmstudy {

/// One statement, with its parameters in the places of ?1, ?2, ... Throws what query throws.
template <class... Parameters>
Rows ask(const std::filesystem::path& results, const std::string& sql, const Parameters&... parameters) {
  const std::array<SqlValue, sizeof...(Parameters)> values{SqlValue(parameters)...};
  return query(results, sql, values);
}

/// The column of the view `jobs` that a parameter of a scene has: "impact_speed" -> "impact_speed_m_s".
/// Throws CatalogError for a name that is no parameter.
std::string column_of_parameter(const std::string& parameter);
/// The value of a parameter as a column of an answer over `jobs`: of the table, or of the study's own, whose
/// name is `study` ("": the column of `jobs`).
std::string sql_of_parameter(const std::string& parameter, const std::string& jobs,
                             const std::string& study = "");

}  // namespace mpmstudy
