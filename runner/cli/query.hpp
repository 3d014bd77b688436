#pragma once
/// `mpmstudy query "SQL"`: asks the catalog. It can change nothing.
#include <string>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct QueryOptions {
  std::string sql;
  std::string format = "table";
  std::string timeout;  ///< "10 s"; "": none
  std::string results;
};

void setup_query(CLI::App&);
/// Throws CatalogError.
int run_query(const QueryOptions&);

}  // namespace mpmstudy
