#include "runner/cli/bench.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "runner/cli/bench_accuracy.hpp"

namespace mpmstudy {

void setup_bench(CLI::App& app) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& verb = *app.add_subcommand("bench", "Measure this machine");
  verb.require_subcommand(1);
  setup_bench_accuracy(verb);
  CLI::App& kernel = *verb.add_subcommand("kernel", "Particle updates a second, fast step against reference");
  kernel.add_option("--particles", options->kernel.particles, "Sizes to measure [10000 150000]")
      ->check(CLI::Range(1000, 100'000'000));
  kernel.add_option("--repetitions", options->kernel.repetitions, "The median of these counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  kernel.add_option("--seconds", options->kernel.seconds, "Processor time of one repetition [s]")
      ->check(CLI::Range(0.001, 600.0))
      ->capture_default_str();
  kernel.add_flag("--json", options->json, "One object a row");
  kernel.callback([options] { finish(run_bench_kernel(*options)); });
}

int run_bench_kernel(const BenchOptions& options) {
  const auto rows = bench_kernel(options.kernel);
  if (!options.json)
    fmt::print("{:<10}{:<11}{:<11}{:>8}{:>11}{:>14}{:>14}{:>17}\n", "scheme", "kernel", "precision",
               "threads", "particles", "M updates/s", "x reference", "bytes/particle");
  for (const KernelBenchRow& r : rows)
    if (options.json)
      fmt::print("{}\n", nlohmann::json{{"scheme", r.scheme},
                                        {"kernel", r.kernel},
                                        {"precision", r.precision},
                                        {"threads", r.threads},
                                        {"particles", r.particles},
                                        {"million_particle_updates_per_s", r.million_particle_updates_per_s},
                                        {"ratio_to_reference", r.ratio_to_reference},
                                        {"bytes_per_particle", r.bytes_per_particle}}
                             .dump());
    else
      fmt::print("{:<10}{:<11}{:<11}{:>8}{:>11}{:>14.2f}{:>14.2f}{:>17.0f}\n", r.scheme, r.kernel,
                 r.precision, r.threads, r.particles, r.million_particle_updates_per_s, r.ratio_to_reference,
                 r.bytes_per_particle);
  return exit_ok;
}

}  // namespace mpmstudy
