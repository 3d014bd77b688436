#pragma once
/// `mpmstudy explain KEY [STUDY...]`: why a job ran, or will run; what made its key new, and where that is
/// said; why it failed. Reads only.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct ExplainOptions {
  std::string key;                 ///< or its first digits
  std::vector<std::string> files;  ///< study files; none: those that the catalog knows
  StudyOptions study;
  std::string results;
};

void setup_explain(CLI::App&);
/// Throws CatalogError for a key that no job has, or that the keys of several jobs begin with.
int run_explain(const ExplainOptions&);

}  // namespace mpmstudy
