#pragma once
/// `mpmstudy export`: views of the catalog as files. A file has its name when it is whole.
#include <string>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct ExportOptions {
  std::string what = "jobs";  ///< a view, or "all"
  std::string study;          ///< "": every study
  std::string format = "csv";
  std::string output;  ///< a file, a folder, or "" / "-": standard output
  std::string results;
};

void setup_export(CLI::App&);
/// Throws CatalogError.
int run_export(const ExportOptions&);

}  // namespace mpmstudy
