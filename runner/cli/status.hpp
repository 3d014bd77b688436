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

/// Names of studies, some of them said by their files. Throws StudyError for a file.
std::vector<std::string> study_names(const std::vector<std::string>& names_or_files);

void setup_status(CLI::App&);
/// Throws CatalogError; StudyError for a file.
int run_status(const StatusOptions&);

}  // namespace mpmstudy
