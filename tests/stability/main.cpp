// The stability suite: runs the hard cases and prints what became of each.
//   stability_suite            all of it, minutes
//   stability_suite --short    cases below a cost, and 50 random scenes
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <exception>
#include <thread>

#include "libmpm/core/thread_clock.hpp"
#include "runner/exec/processors.hpp"
#include "tests/stability/case.hpp"

namespace {

using stability::Case;
using stability::Outcome;

Outcome run_timed(const Case& c) {
  const double start = mpm::thread_cpu_seconds();
  Outcome o;
  try {
    o = c.run();
  } catch (const std::exception& error) {
    o.verdict = "threw";
    o.note = error.what();
  }
  o.cpu_s = mpm::thread_cpu_seconds() - start;
  return o;
}

std::vector<Outcome> run_all(const std::vector<Case>& cases, unsigned workers) {
  std::vector<Outcome> outcomes(cases.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (unsigned w = 0; w < workers; ++w)
    threads.emplace_back([&] {
      for (std::size_t i; (i = next.fetch_add(1)) < cases.size();) outcomes[i] = run_timed(cases[i]);
    });
  for (auto& t : threads) t.join();
  return outcomes;
}

void print_row(const Case& c, const Outcome& o) {
  fmt::print("| {} | {} | {} | {}{} | {} | {:.1e} | {:.2f} ... {:.2f} | {:.2f} | {:.2f} | {} |\n", c.name,
             c.variant, c.expected, o.as_expected ? "" : "**", o.as_expected ? o.verdict : o.verdict + "**",
             o.steps, o.energy_error, o.smallest_density, o.largest_density, o.largest_cfl, o.cpu_s, o.note);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Hard cases: what holds, what breaks, and where");
  int random = 500;
  std::uint64_t seed = 1;
  bool only_short = false;
  std::string filter, folder = SOURCE_DIR "/studies/stability";
  unsigned workers = static_cast<unsigned>(mpmstudy::usable_processors());
  app.add_option("--random", random,
                 "Random scenes of the kinds; half as many of bodies, a tenth in three dimensions")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  app.add_option("--seed", seed, "Of the first random scene")->capture_default_str();
  app.add_option("--filter", filter, "Only cases whose name has this in it");
  app.add_option("-j,--workers", workers, "Threads")->check(CLI::Range(1u, 1024u));
  app.add_flag("--short", only_short,
               "Leave out what takes more than seconds; 50 random scenes of the kinds");
  CLI11_PARSE(app, argc, argv);
  constexpr double short_cost = 3e7;  // particle updates
  if (only_short) random = std::min(random, 50);

  std::vector<Case> cases;
  const auto take = [&](std::vector<Case> more) {
    for (Case& c : more)
      if (c.name.find(filter) != std::string::npos && (!only_short || c.cost <= short_cost))
        cases.push_back(std::move(c));
  };
  take(stability::study_cases(folder));
  take(stability::step_limit_cases());
  take(stability::body_cases());
  take(stability::same_cases());
  const std::size_t told = cases.size();  // each of these has a row; random scenes only where they surprise
  take(stability::random_cases(random, seed));
  take(stability::random_body_cases(random / 2, seed));
  take(stability::random_solid_cases(random / 10, seed));
  const std::vector<Outcome> outcomes = run_all(cases, workers);

  fmt::print(
      "| case | variant | expected | came out | steps | energy error | rho/rho0 | largest CFL | CPU s | note "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  int passed = 0, failed = 0, random_done = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    ++(outcomes[i].as_expected ? passed : failed);
    if (i >= told && outcomes[i].verdict == "held") ++random_done;
    if (i < told || !outcomes[i].as_expected) print_row(cases[i], outcomes[i]);
  }
  if (cases.size() > told)
    fmt::print("\nRandom scenes: {}, of which {} ran to their end and {} were stopped with a reason.\n",
               cases.size() - told, random_done, cases.size() - told - static_cast<std::size_t>(random_done));
  fmt::print("\n{} passed, {} failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
