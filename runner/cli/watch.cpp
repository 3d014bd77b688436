#include "runner/cli/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

namespace mpmstudy {
namespace {

/// Whether work goes on, here, on another host or in the queue of a cluster.
bool anybody(const StudiesReport& report) {
  return report.state.processes > 0 || std::ranges::any_of(report.submissions, &Submission::may_be_queued);
}

}  // namespace

void setup_watch(CLI::App& app) {
  const auto options = std::make_shared<WatchOptions>();
  CLI::App& verb = *app.add_subcommand("watch", "Say how far the studies are until all jobs are decided");
  verb.add_option("STUDY", options->status.studies, "Names of studies, or study files [all]");
  verb.add_option("--every", options->every_s, "Period [s]")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  verb.add_flag("--wait", options->wait, "Wait also while nobody runs what is planned");
  add_results_option(verb, options->status.results);
  verb.callback([options] { end_with(run_watch(*options)); });
}

int run_watch(const WatchOptions& options) {
  using Clock = std::chrono::steady_clock;
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  const double patience = std::max(options.patience_s, 2 * options.every_s);
  auto seen = Clock::now();  // when a process last ran jobs
  while (true) {
    const auto report = read_report(options.status);
    if (terminal) fmt::print("\x1b[H\x1b[J");  // from the top of an empty screen
    print_report(report, false);
    const int code = report.exit_code();
    const bool alone = !anybody(report);
    if (code != exit_stopped && alone) return code;
    if (!alone) seen = Clock::now();
    if (alone)
      fmt::print("\nnobody runs these studies now; `mpmstudy run STUDY` goes on with them{}\n",
                 options.wait ? "" : "; `mpmstudy watch --wait` waits for it");
    std::fflush(stdout);
    if (alone && !options.wait && std::chrono::duration<double>(Clock::now() - seen).count() >= patience)
      return code;
    std::this_thread::sleep_for(std::chrono::duration<double>(options.every_s));
    if (!terminal) fmt::print("\n");
  }
}

}  // namespace mpmstudy
