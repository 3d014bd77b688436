#pragma once
/// `mpmstudy merge FOLDER...`: takes over the jobs of other results folders. Doing it again changes nothing.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct MergeOptions {
  std::vector<std::string> folders;
  std::string results;
};

void setup_merge(CLI::App&);
/// exit_failed if two results stand under one key, a file is damaged, or a folder cannot be read; the rest is
/// merged all the same. Throws CatalogError for the results folder itself.
int run_merge(const MergeOptions&);

}  // namespace mpmstudy
