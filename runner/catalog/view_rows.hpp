#pragma once
/// Whole views of a catalog, for export. Each call opens the catalog read-only; all throw CatalogError.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runner/catalog/query.hpp"

namespace mpmstudy {

struct View {
  std::string name;
  std::vector<std::string> columns;
  bool has(std::string_view column) const;
};

/// Every view that the catalog has, in the order of their names.
std::vector<View> views_of(const std::filesystem::path& results);

/// Rows of a view, of one study ("": of all), in an order that is the same for the same catalog.
void write_view(const std::filesystem::path& results, const View&, const std::string& study, RowSink&);

}  // namespace mpmstudy
