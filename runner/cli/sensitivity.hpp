#pragma once
/// `mpmstudy sensitivity STUDY`: how much each swept parameter does to a result.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct SensitivityOptions {
  std::string name;             ///< of the study, or its file
  std::vector<std::string> of;  ///< results; empty: what the study's fits and figures show
  std::vector<std::string> at;  ///< "material=copper": one of the words that are swept
  std::string results;
  StudyOptions study;
  bool json = false;
};

void setup_sensitivity(CLI::App&);
/// Throws StudyError, CatalogError.
int run_sensitivity(const SensitivityOptions&);

}  // namespace mpmstudy
