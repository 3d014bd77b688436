#pragma once
/// `mpmstudy show STUDY...`: what studies have come to, as `run` prints it at its end, without running
/// anything.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct ShowOptions {
  std::vector<std::string> studies;  ///< names in the catalog, or study files
  std::string results;
  StudyOptions study;
  bool json = false;
};

void setup_show(CLI::App&);
/// Throws StudyError, CatalogError.
int run_show(const ShowOptions&);

}  // namespace mpmstudy
