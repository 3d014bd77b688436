#include "runner/cli/bench.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "libmpm/scene/parameters.hpp"
#include "runner/cli/bench_accuracy.hpp"
#include "runner/cli/bench_exact.hpp"
#include "runner/cli/bench_lagrangian.hpp"

namespace mpmstudy {
namespace {

std::map<std::string, mpm::Space> spaces_by_name() {
  const mpm::Choice& spaces = *mpm::find_choice("space");
  std::map<std::string, mpm::Space> all;
  for (std::size_t i = 0; i < spaces.allowed.size(); ++i) {
    mpm::Scene scene;
    spaces.set(scene, i);
    all[std::string(spaces.allowed[i])] = scene.space;
  }
  return all;
}

}  // namespace

void setup_bench(CLI::App& app) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& verb = *app.add_subcommand("bench", "Measure this machine");
  verb.require_subcommand(1);
  setup_bench_accuracy(verb);
  setup_bench_exact(verb);
  setup_bench_lagrangian(verb);
  CLI::App& kernel =
      *verb.add_subcommand("kernel", "Particle updates per second, fast step against reference");
  kernel
      .add_option("--space", options->kernel.spaces, "Spaces to measure [plane-strain axisymmetric three-d]")
      ->transform(CLI::CheckedTransformer(spaces_by_name()));
  kernel.add_option("--particles", options->kernel.particles, "Sizes to measure [10000 150000]")
      ->check(CLI::Range(1000, 100'000'000));
  kernel.add_option("--threads", options->kernel.threads, "Threads in one run, by time that passes [1]")
      ->check(CLI::Range(1, 1024));
  kernel.add_option("--repetitions", options->kernel.repetitions, "The median of these counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  kernel.add_option("--seconds", options->kernel.seconds, "Processor time of one repetition [s]")
      ->check(CLI::Range(0.001, 600.0))
      ->capture_default_str();
  kernel.add_option("--steps", options->kernel.steps, "Steps of one repetition, in place of --seconds")
      ->check(CLI::Range(1, 1'000'000));
  kernel.add_flag("--whole-run", options->whole_run,
                  "Rates of the fast step in each tenth of a run to 12 ns, in place of the table");
  kernel.add_flag("--elastic", options->kernel.elastic, "A body that does not yield");
  kernel.add_flag("--kinematic", options->kernel.kinematic,
                  "Half of the hardening is kinematic: back stress");
  kernel.add_flag("--json", options->json, "One object a row");
  kernel.callback([options] { end_with(run_bench_kernel(*options)); });
}

void print_whole_runs(const BenchOptions& options) {
  if (!options.json)
    fmt::print("{:<14}{:<10}{:<10}{:>10}  M updates/s in each tenth of the run\n", "space", "scheme",
               "precision", "particles");
  for (const WholeRunRow& r : bench_whole_run(options.kernel)) {
    if (options.json) {
      fmt::print("{}\n", nlohmann::json{{"space", r.space},
                                        {"scheme", r.scheme},
                                        {"precision", r.precision},
                                        {"particles", r.particles},
                                        {"million_particle_updates_per_s", r.million_particle_updates_per_s}}
                             .dump());
      continue;
    }
    fmt::print("{:<14}{:<10}{:<10}{:>10} ", r.space, r.scheme, r.precision, r.particles);
    for (const double rate : r.million_particle_updates_per_s)
      if (rate > 0) fmt::print("{:>7.1f}", rate);
    fmt::print("{}\n", r.million_particle_updates_per_s.back() > 0 ? "" : "  and broke down");
  }
}

int run_bench_kernel(const BenchOptions& options) {
  if (options.whole_run) {
    print_whole_runs(options);
    return exit_ok;
  }
  const KernelBench bench = bench_kernel(options.kernel);
  const Roofline& roofline = bench.roofline;
  if (!options.json) {
    fmt::print("roofline: {:.1f} Gflop/s double, {:.1f} float; {:.1f} GB/s\n", roofline.gigaflops_double,
               roofline.gigaflops_float, roofline.gigabytes_per_second);
    fmt::print("{:<14}{:<10}{:<11}{:<10}{:>8}{:>10}{:>13}{:>13}{:>16}{:>10}{:>7}{:>7}{:>11}\n", "space",
               "scheme", "kernel", "precision", "threads", "particles", "M updates/s", "x reference",
               "bytes/particle", "roofline", "sort", "grid", "particles");
  }
  for (const KernelBenchRow& r : bench.rows) {
    const bool fast = r.kernel == "fast";
    const double particles_share = fast ? 1 - r.sort_share - r.grid_share : 0;
    if (options.json)
      fmt::print("{}\n", nlohmann::json{{"space", r.space},
                                        {"scheme", r.scheme},
                                        {"kernel", r.kernel},
                                        {"precision", r.precision},
                                        {"threads", r.threads},
                                        {"particles", r.particles},
                                        {"million_particle_updates_per_s", r.million_particle_updates_per_s},
                                        {"ratio_to_reference", r.ratio_to_reference},
                                        {"bytes_per_particle", r.bytes_per_particle},
                                        {"roofline_share", r.roofline_share},
                                        {"sort_share", r.sort_share},
                                        {"grid_share", r.grid_share},
                                        {"particles_share", particles_share},
                                        {"gigaflops_double", roofline.gigaflops_double},
                                        {"gigaflops_float", roofline.gigaflops_float},
                                        {"gigabytes_per_second", roofline.gigabytes_per_second}}
                             .dump());
    else
      fmt::print(
          "{:<14}{:<10}{:<11}{:<10}{:>8}{:>10}{:>13.2f}{:>13.2f}{:>16.0f}{:>10}{:>6.0f}%{:>6.0f}%{:>10.0f}%"
          "\n",
          r.space, r.scheme, r.kernel, r.precision, r.threads, r.particles, r.million_particle_updates_per_s,
          r.ratio_to_reference, r.bytes_per_particle,
          r.roofline_share > 0 ? fmt::format("{:.0f}%", 100 * r.roofline_share) : "-", 100 * r.sort_share,
          100 * r.grid_share, 100 * particles_share);
  }
  return exit_ok;
}

}  // namespace mpmstudy
