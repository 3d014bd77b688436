#include "runner/cli/bench_lagrangian.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "libmpm/verification/lagrangian/collapse.hpp"
#include "runner/plan/plan.hpp"
#include "runner/status/label.hpp"
#include "runner/study/parameter_value.hpp"

namespace mpmstudy {

namespace lagrangian = mpm::verification::lagrangian;

namespace {

/// Key and swept parameters of a job, as the columns that every line begins with.
std::string columns_of(const Study& study, const Job& job) {
  std::string text = short_key(job.key);
  for (const std::string& name : study.swept) text += fmt::format(",{}", readable_parameter(job.scene, name));
  return text;
}

/// Empty where it is no number: the mesh stopped, or the meshes do not go one way.
std::string number_or_nothing(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

void print_meshes(const std::string& columns, const lagrangian::CollapseLadder& ladder) {
  for (const lagrangian::Collapse& c : ladder.meshes)
    fmt::print("{},{},{},,{:.2g},{},{}\n", columns, c.cells, number_or_nothing(c.collapsibility),
               c.energy_error, number_or_nothing(c.stop_time), c.stopped);
  fmt::print("{},limit,{},{},,,\n", columns, number_or_nothing(ladder.collapsibility.extrapolated),
             number_or_nothing(ladder.collapsibility.order));
}

void print_histories(const std::string& columns, const lagrangian::CollapseLadder& ladder) {
  for (const lagrangian::Collapse& c : ladder.meshes)
    for (std::size_t k = 0; k < c.time.size(); ++k)
      fmt::print("{},{},{:.6g},{:.6g}\n", columns, c.cells, c.time[k], c.area[k]);
}

}  // namespace

void setup_bench_lagrangian(CLI::App& bench) {
  const auto options = std::make_shared<BenchLagrangianOptions>();
  CLI::App& verb = *bench.add_subcommand(
      "lagrangian",
      "How far cavities close by a Lagrangian code, on three meshes with their limit, as CSV: plane strain, "
      "cavities that stay open. What --cells says has no effect here");
  verb.add_option("FILE", options->file, "A study of the scene cavity-impact")->required();
  verb.add_option("--per-radius", options->per_radius, "Cells to the radius on the coarsest of the meshes")
      ->check(CLI::Range(4, 100))
      ->capture_default_str();
  verb.add_flag("--history", options->history, "Open area against time, in place of the table");
  add_study_options(verb, options->study);
  verb.callback([options] { end_with(run_bench_lagrangian(*options)); });
}

int run_bench_lagrangian(const BenchLagrangianOptions& options) {
  const Study study = read_study(options.file, options.study);
  std::string header = "job";
  for (const std::string& name : study.swept) header += "," + name;
  fmt::print(
      "{}\n",
      header + (options.history ? ",cells_per_radius,time_s,area_m2"
                                : ",cells_per_radius,collapsibility,order,energy_error,stop_time_s,stopped"));
  for (const Job& job : make_plan(study).jobs) try {
      const auto ladder = lagrangian::collapse_ladder(job.scene, options.per_radius);
      (options.history ? print_histories : print_meshes)(columns_of(study, job), ladder);
      std::fflush(stdout);
    } catch (const std::invalid_argument& error) {
      throw StudyError(fmt::format("{}: job {}: {}", options.file, short_key(job.key), error.what()));
    }
  return exit_ok;
}

}  // namespace mpmstudy
