#pragma once
/// `mpmstudy retry [KEY...]`: failed jobs are planned again; the next `run` takes them.
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct RetryOptions {
  std::vector<std::string> keys;  ///< or their first digits; none: every job
  RetryFilter filter;
  std::string results;
};

void setup_retry(CLI::App&);
/// Throws CatalogError.
int run_retry(const RetryOptions&);

}  // namespace mpmstudy
