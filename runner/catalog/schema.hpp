#pragma once
/// What is inside a catalog: tables (private), views (public, in views.cpp; README.md), and how one version
/// becomes the next. Rules:
/// - a table or a view changes by a new Migration at the end of migrations(), never by editing an old one;
/// - a parameter is a row of libmpm/scene/parameters.hpp: its column is added when the catalog is opened;
/// - columns of a view keep their name and meaning; new ones come at its end.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mpmstudy {

/// Marks a SQLite file as a catalog: "MPMS".
inline constexpr std::int32_t catalog_application_id = 0x4D504D53;

/// One step of the layout: SQL that turns version - 1 into version.
struct Migration {
  std::int32_t version;
  std::string_view sql;
};

/// A column that a parameter of a scene has.
struct ParameterColumn {
  std::string name;
  std::string type;  ///< "REAL" or "TEXT"
};

/// Everything that opening makes sure of; a value, so that tests open with an older or a newer one.
struct CatalogSchema {
  std::vector<Migration> migrations;  ///< ascending, version 1 first
  std::vector<ParameterColumn> parameters;

  std::int32_t version() const { return migrations.back().version; }
};

/// The layout of this build.
CatalogSchema current_catalog_schema();

/// SQL over a row of `job`: 1 where an older physics made it, that of its kernel
/// (libmpm/scene/physics_version.hpp). The column of the kernel is in double quotes: a catalog that is older
/// than that column has none.
std::string stale_sql();

/// SQL that drops and makes every view, over the parameter columns that the catalog has.
std::string view_sql(std::span<const std::string> parameter_columns);

}  // namespace mpmstudy
