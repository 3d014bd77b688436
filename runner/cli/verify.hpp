#pragma once
/// `mpmstudy verify N`: runs N done jobs again, chosen at random, and compares every bit. Writes nothing to
/// the catalog.
#include <cstdint>
#include <string>

#include "runner/cli/run.hpp"

namespace mpmstudy {

struct VerifyOptions {
  int jobs = 1;
  std::uint64_t seed = 0;  ///< 0: another choice every time
  int workers = 0;         ///< 0: as many as there are processors
  bool files = false;      ///< look at every file of fields, too
  std::string results;
};

void setup_verify(CLI::App&, RunSeams);
/// exit_failed if a job came out otherwise, or a file is damaged. Throws CatalogError.
int run_verify(const VerifyOptions&, const RunSeams&);

}  // namespace mpmstudy
