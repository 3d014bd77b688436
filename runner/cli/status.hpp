#pragma once
/// `mpmstudy status [STUDY...]`: how far the studies of a catalog are. Reads only.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct StatusOptions {
  std::vector<std::string> studies;  ///< names, or study files; none: all
  std::string results;
  bool json = false;
};

void setup_status(CLI::App&);
/// Throws CatalogError; StudyError for a file.
int run_status(const StatusOptions&);

}  // namespace mpmstudy
