#include "runner/cli/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include "runner/catalog/reader.hpp"

namespace mpmstudy {
namespace {

bool work_left(const CatalogState& state) {
  for (const auto& study : state.studies)
    if (study.jobs.contains(JobStatus::planned) || study.jobs.contains(JobStatus::running)) return true;
  return false;
}

}  // namespace

void setup_watch(CLI::App& app) {
  const auto options = std::make_shared<WatchOptions>();
  CLI::App& verb = *app.add_subcommand("watch", "Say how far the studies are until all jobs are decided");
  verb.add_option("STUDY", options->status.studies, "Names of studies, or study files [all]");
  verb.add_option("--every", options->every_s, "Period [s]")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  add_results_option(verb, options->status.results);
  verb.callback([options] { finish(run_watch(*options)); });
}

int run_watch(const WatchOptions& options) {
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  const auto names = study_names(options.status.studies);
  while (true) {
    if (terminal) fmt::print("\x1b[H\x1b[J");  // from the top of an empty screen
    run_status(options.status);
    std::fflush(stdout);
    if (!work_left(read_state(options.status.results, names))) return exit_ok;
    std::this_thread::sleep_for(std::chrono::duration<double>(options.every_s));
    if (!terminal) fmt::print("\n");
  }
}

}  // namespace mpmstudy
