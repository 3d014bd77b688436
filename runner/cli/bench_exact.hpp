#pragma once
/// `mpmstudy bench exact`: what the library makes of problems whose answer is known.
#include <string>
#include <vector>

#include "libmpm/verification/problems/exact_bench.hpp"
#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct BenchExactOptions {
  std::vector<std::string> problems;  ///< names; empty: all
  mpm::verification::ExactOptions exact;
  std::string scheme;          ///< as study files write it; empty: the default of each scene
  int particles_per_cell = 0;  ///< 0: the default of each scene
  unsigned workers = 1;
  bool json = false, csv = false;
};

void setup_bench_exact(CLI::App& bench);
int run_bench_exact(const BenchExactOptions&);

}  // namespace mpmstudy
