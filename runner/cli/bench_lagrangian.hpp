#pragma once
/// `mpmstudy bench lagrangian`: the jobs of a study by the Lagrangian code that collapses are held against.
#include <string>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct BenchLagrangianOptions {
  std::string file;      ///< a study of cavities in blocks that fall onto a wall
  StudyOptions study;    ///< --set
  int per_radius = 7;    ///< cells to the radius, of the coarsest of three meshes
  bool history = false;  ///< open area against time, in place of the table
};

void setup_bench_lagrangian(CLI::App& bench);
int run_bench_lagrangian(const BenchLagrangianOptions&);

}  // namespace mpmstudy
