#pragma once
/// `mpmstudy bench accuracy`: what an error costs.
#include <string>

#include "runner/bench/accuracy_bench.hpp"
#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct BenchAccuracyOptions {
  AccuracyBenchOptions bench;
  bool json = false, csv = false;
  std::string figures;  ///< folder; empty: none are drawn
};

void setup_bench_accuracy(CLI::App& bench);
int run_bench_accuracy(const BenchAccuracyOptions&);

}  // namespace mpmstudy
