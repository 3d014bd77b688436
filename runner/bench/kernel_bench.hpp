#pragma once
/// How fast the time step is: the strong cavity scene (1120 m/s; 4 particles per cell, of three axes 8),
/// stepped for a while by the fast step and by the reference in turn, everything on but the measures.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "runner/bench/roofline.hpp"

namespace mpmstudy {

struct KernelBenchRow {
  std::string space;
  std::string scheme;     ///< shape functions
  std::string kernel;     ///< fast, reference
  std::string precision;  ///< double, float
  int threads = 1;
  std::int64_t particles = 0;
  double million_particle_updates_per_s = 0;  ///< median of the repetitions; of processor time, or, with more
                                              ///< than one thread, of time that passed
  double ratio_to_reference = 0;              ///< of the same run
  double bytes_per_particle = 0;              ///< particles, nodes and what the step keeps beside them
  double roofline_share = 0;  ///< of what the roofline allows; 0 for the reference and for more threads
  double sort_share = 0, grid_share = 0;  ///< of the time of a step; the rest is the pass over the particles
};

struct KernelBenchOptions {
  std::vector<mpm::Space> spaces = {mpm::Space::plane_strain, mpm::Space::axisymmetric, mpm::Space::three_d};
  std::vector<std::int64_t> particles = {10000, 150000};  ///< wanted; the scene gives about that many
  std::vector<int> threads = {1};                         ///< of the fast step, in one run
  int repetitions = 5;                                    ///< of which the median counts
  double seconds = 0.3;                                   ///< of one repetition
  int steps = 0;  ///< of one repetition; 0: as many as `seconds` hold. The same number shows sizes in the
                  ///< same state of the run, where the same time takes small ones much further
  bool elastic = false;    ///< without plasticity
  bool kinematic = false;  ///< half of the hardening is kinematic
};

struct KernelBench {
  Roofline roofline;
  std::vector<KernelBenchRow> rows;
};

/// Rows of both kernels for every space, scheme and size. Kernels take turns, so that a machine that changes
/// its speed changes the ratio little.
KernelBench bench_kernel(const KernelBenchOptions&);

/// The rate of the fast step from the impact to 12 ns, when jets and rarefaction have mixed the particles.
struct WholeRunRow {
  std::string space, scheme, precision;
  std::int64_t particles = 0;
  std::array<double, 10> million_particle_updates_per_s{};  ///< in each tenth of the run's time; 0
                                                            ///< once the run has broken down
};
std::vector<WholeRunRow> bench_whole_run(const KernelBenchOptions&);

}  // namespace mpmstudy
