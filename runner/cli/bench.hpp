#pragma once
/// `mpmstudy bench kernel`: particle updates per second of the time step on this machine.
#include "runner/bench/kernel_bench.hpp"
#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct BenchOptions {
  KernelBenchOptions kernel;
  bool json = false;
  bool whole_run = false;  ///< tenths of a run in place of the table
};

void setup_bench(CLI::App&);
int run_bench_kernel(const BenchOptions&);

}  // namespace mpmstudy
