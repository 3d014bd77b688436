#include "runner/cli/bench_accuracy.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/plot.hpp"

namespace mpmstudy {
namespace {

void print_json(const AccuracyRow& r) {
  const auto number = [](double v) { return std::isfinite(v) ? nlohmann::json(v) : nlohmann::json(nullptr); };
  fmt::print("{}\n", nlohmann::json{{"problem", r.problem},
                                    {"quantity", r.what},
                                    {"scheme", r.scheme.shape},
                                    {"particles_per_cell", r.scheme.particles_per_cell},
                                    {"default", r.scheme.is_default},
                                    {"transfer", r.scheme.transfer},
                                    {"precision", r.scheme.precision},
                                    {"cell_size", r.cell_size},
                                    {"value", number(r.value)},
                                    {"reference", number(r.reference)},
                                    {"reference_error", number(r.reference_error)},
                                    {"error", number(r.error)},
                                    {"cpu_s", r.cpu_s},
                                    {"on_front", r.on_front},
                                    {"problem_of_run", r.problem_of_run}}
                         .dump());
}

void print_csv(const AccuracyRow& r) {
  fmt::print("{},{},{},{},{},{},{:.6g},{:.10g},{:.10g},{:.3g},{:.4g},{:.4g},{}\n", r.problem, r.what,
             r.scheme.shape, r.scheme.particles_per_cell, r.scheme.transfer, r.scheme.precision, r.cell_size,
             r.value, r.reference, r.reference_error, r.error, r.cpu_s, r.on_front ? 1 : 0);
}

void print_line(const AccuracyRow& r) {
  fmt::print("{:<22}{:<28}{:>12.4g}", r.problem, r.scheme.label(), r.cell_size);
  if (!r.problem_of_run.empty())
    fmt::print("  {}\n", r.problem_of_run.substr(0, 70));
  else
    fmt::print("{:>14.6g}{:>12.2e}{:>10.3f} {}{}\n", r.value, r.error, r.cpu_s, r.on_front ? "front" : "",
               r.scheme.is_default ? " default" : "");
}

/// One figure per problem: error against processor time, one curve per scheme, the front on top.
void draw_figures(const std::vector<AccuracyRow>& rows, const std::filesystem::path& folder) {
  for (auto first = rows.begin(); first != rows.end();) {
    const auto last =
        std::find_if(first, rows.end(), [&](const AccuracyRow& r) { return r.problem != first->problem; });
    analysis::Plot plot;
    plot.kind = analysis::Plot::Kind::xy;
    plot.log_x = plot.log_y = true;
    plot.title = fmt::format("{}: error of {} against processor time", first->problem, first->what);
    if (first->reference_error > 0)
      plot.footer = fmt::format("reference {:.5g} +- {:.1g}: the finest runs, extrapolated", first->reference,
                                first->reference_error);
    plot.x = {"Processor time", "", "s"};
    plot.y = {"Relative error", "", "1"};
    std::vector<const AccuracyRow*> front;
    for (auto r = first; r != last; ++r) {
      if (r->on_front) front.push_back(&*r);
      if (!r->scheme.is_default && std::none_of(first, last, [&](const AccuracyRow& other) {
            return other.on_front && other.scheme == r->scheme;
          }))
        continue;  // on no front: in the table, not in the figure
      const std::string label = r->scheme.label() + (r->scheme.is_default ? " (default)" : "");
      if (plot.series.empty() || plot.series.back().label != label)
        plot.series.push_back({label, {}, {}, {}});
      plot.series.back().x.push_back(r->cpu_s);
      plot.series.back().y.push_back(r->error);
    }
    std::ranges::sort(front, {}, &AccuracyRow::cpu_s);
    analysis::Series line{"front", {}, {}, {}};
    for (const AccuracyRow* r : front) line.x.push_back(r->cpu_s), line.y.push_back(r->error);
    plot.series.push_back(line);
    analysis::draw(plot, folder / ("accuracy-" + first->problem));
    fmt::print(stderr, "{}\n", (folder / ("accuracy-" + first->problem + ".png")).string());
    first = last;
  }
}

}  // namespace

void setup_bench_accuracy(CLI::App& bench) {
  const auto options = std::make_shared<BenchAccuracyOptions>();
  CLI::App& verb = *bench.add_subcommand("accuracy", "Error against processor time, of every scheme");
  std::vector<std::string> names;
  for (const AccuracyProblem& p : accuracy_problems()) names.push_back(p.name);
  verb.add_option("--problem", options->bench.problems, "Only these")->check(CLI::IsMember(names));
  verb.add_option("--skip-finest", options->bench.skip_finest, "Rungs to leave out at the fine end")
      ->check(CLI::Range(0, 2))
      ->capture_default_str();
  verb.add_option("-j,--workers", options->bench.workers, "Runs at once")
      ->check(CLI::Range(1u, 1024u))
      ->capture_default_str();
  CLI::Option* json = verb.add_flag("--json", options->json, "One object a row");
  verb.add_flag("--csv", options->csv, "A header and a line per row")->excludes(json);
  verb.add_option("--figures", options->figures, "Folder to draw the fronts into");
  verb.callback([options] { end_with(run_bench_accuracy(*options)); });
}

int run_bench_accuracy(const BenchAccuracyOptions& options) {
  AccuracyBenchOptions bench = options.bench;
  if (isatty(STDERR_FILENO))
    bench.progress = [](std::size_t done, std::size_t all) {
      fmt::print(stderr, "\r{} of {} runs{}", done, all, done == all ? "\n" : "");
      std::fflush(stderr);
    };
  const auto rows = bench_accuracy(bench);
  if (options.csv)
    fmt::print(
        "problem,quantity,scheme,particles_per_cell,transfer,precision,cell_size_m,value,reference,reference_"
        "error,"
        "error,cpu_s,on_front\n");
  else if (!options.json)
    fmt::print("{:<22}{:<28}{:>12}{:>14}{:>12}{:>10}\n", "problem", "scheme", "cell [m]", "value", "error",
               "CPU s");
  for (const AccuracyRow& r : rows) options.json ? print_json(r) : options.csv ? print_csv(r) : print_line(r);
  if (!options.figures.empty()) draw_figures(rows, options.figures);
  return exit_ok;
}

}  // namespace mpmstudy
