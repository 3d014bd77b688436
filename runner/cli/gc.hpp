#pragma once
/// `mpmstudy gc`: removes what no study has: rows of jobs, and folders of fields and checkpoints.
#include <string>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct GcOptions {
  bool dry_run = false;
  std::string results;
};

void setup_gc(CLI::App&);
/// exit_failed if a folder could not be removed. Throws CatalogError.
int run_gc(const GcOptions&);

}  // namespace mpmstudy
