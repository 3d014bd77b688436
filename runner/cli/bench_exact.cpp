#include "runner/cli/bench_exact.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {

using namespace mpm::verification;

namespace {

std::string_view word(Judged judged) {
  switch (judged) {
    case Judged::relative:
      return "relative";
    case Judged::absolute:
      return "absolute";
    case Judged::shortfall:
      return "shortfall";
  }
  return "";
}

/// An error or a tolerance: those of relative differences in percent.
std::string error_text(double error, Judged judged) {
  if (std::isnan(error)) return "-";
  return judged == Judged::relative ? fmt::format("{:.2g} %", 100 * error) : fmt::format("{:.2g}", error);
}

std::string value_text(const ExactNumber& n, double value) {
  if (std::isnan(value)) return "not measured";
  return n.unit == "1" ? fmt::format("{:.5g}", value) : readable(value, n.unit);
}

void print_json(const ExactRow& r) {
  const auto number = [](double v) { return std::isfinite(v) ? nlohmann::json(v) : nlohmann::json(nullptr); };
  const ExactNumber& n = r.number;
  fmt::print("{}\n", nlohmann::json{{"problem", r.problem->name},
                                    {"quantity", n.quantity},
                                    {"unit", n.unit},
                                    {"exact", n.exact},
                                    {"ours", number(n.ours)},
                                    {"error", number(n.error())},
                                    {"judged", word(n.judged)},
                                    {"tolerance", n.tolerance},
                                    {"holds", n.holds()},
                                    {"trouble", n.trouble},
                                    {"problem_cpu_s", r.cpu_s}}
                         .dump());
}

void print_csv(const ExactRow& r) {
  const ExactNumber& n = r.number;
  fmt::print("{},\"{}\",{},{:.10g},{:.10g},{:.4g},{},{:.4g},{},{:.4g}\n", r.problem->name, n.quantity, n.unit,
             n.exact, n.ours, n.error(), word(n.judged), n.tolerance, n.holds() ? 1 : 0, r.cpu_s);
}

void print_line(const ExactRow& r) {
  const ExactNumber& n = r.number;
  fmt::print("{:<21}{:<46}{:>15}{:>15}{:>11}{:>11}  {}\n", r.problem->name, n.quantity,
             value_text(n, n.exact), value_text(n, n.ours), error_text(n.error(), n.judged),
             error_text(n.tolerance, n.judged),
             n.holds()           ? "yes"
             : n.trouble.empty() ? "NO"
                                 : "NO: " + n.trouble);
}

void print_summary(const std::vector<ExactRow>& rows) {
  double cpu_s = 0;
  std::size_t problems = 0;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (k == 0 || rows[k].problem != rows[k - 1].problem) cpu_s += rows[k].cpu_s, ++problems;
  const auto hold = std::ranges::count_if(rows, [](const ExactRow& r) { return r.number.holds(); });
  fmt::print("{} of {} numbers hold, {} problems, {:.1f} CPU s\n", hold, rows.size(), problems, cpu_s);
}

}  // namespace

void setup_bench_exact(CLI::App& bench) {
  const auto options = std::make_shared<BenchExactOptions>();
  CLI::App& verb = *bench.add_subcommand(
      "exact",
      "The ladder of exact answers: exact, ours, error, tolerance. Verdicts do not fail the command");
  std::vector<std::string> names;
  std::string footer = "Problems:\n";
  for (const ExactProblem& p : exact_problems()) {
    names.push_back(p.name);
    footer += fmt::format("  {:<21}{}\n", p.name, p.what);
  }
  verb.footer(footer);
  const auto shapes = mpm::find_choice("scheme")->allowed;
  verb.add_option("--problem", options->problems, "Only these")
      ->type_name("NAME...")
      ->check(CLI::IsMember(names).description(""));
  verb.add_option("--cells", options->exact.cells,
                  "Every cell size times this: 2 for a quick look; tolerances stay those of 1")
      ->type_name("FACTOR")
      ->check(CLI::Range(0.25, 4.0))
      ->capture_default_str();
  verb.add_option("--scheme", options->scheme, "For all, instead of the default of each scene")
      ->check(CLI::IsMember(std::vector<std::string>(shapes.begin(), shapes.end())));
  verb.add_option("--particles-per-cell", options->particles_per_cell, "For all, likewise")
      ->check(CLI::IsMember({1, 4, 9, 16}));
  verb.add_option("-j,--workers", options->workers, "Problems at once")
      ->check(CLI::Range(1u, 1024u))
      ->capture_default_str();
  CLI::Option* json = verb.add_flag("--json", options->json, "One object a row");
  verb.add_flag("--csv", options->csv, "A header and a line per row")->excludes(json);
  verb.callback([options] { end_with(run_bench_exact(*options)); });
}

int run_bench_exact(const BenchExactOptions& options) {
  ExactOptions exact = options.exact;
  if (!options.scheme.empty()) {
    const mpm::Choice& shapes = *mpm::find_choice("scheme");
    mpm::Scene scene;
    shapes.set(scene, static_cast<std::size_t>(std::ranges::find(shapes.allowed, options.scheme) -
                                               shapes.allowed.begin()));
    exact.scheme = scene.numerics.scheme;
  }
  if (options.particles_per_cell != 0) exact.particles_per_cell = options.particles_per_cell;
  const auto rows = bench_exact(options.problems, exact, options.workers);
  if (options.csv)
    fmt::print("problem,quantity,unit,exact,ours,error,judged,tolerance,holds,problem_cpu_s\n");
  else if (!options.json)
    fmt::print("{:<21}{:<46}{:>15}{:>15}{:>11}{:>11}  holds\n", "problem", "quantity", "exact", "ours",
               "error", "tolerance");
  for (const ExactRow& r : rows) options.json ? print_json(r) : options.csv ? print_csv(r) : print_line(r);
  if (!options.json && !options.csv) print_summary(rows);
  return exit_ok;
}

}  // namespace mpmstudy
