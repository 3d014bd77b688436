#include "runner/cli/figures.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/finish/figures.hpp"
#include "runner/slurm/shell_word.hpp"

namespace mpmstudy {

void setup_figures(CLI::App& app) {
  const auto options = std::make_shared<FiguresOptions>();
  CLI::App& verb = *app.add_subcommand("figures", "Draw the figures of studies from the catalog");
  verb.add_option("STUDY", options->files, "Study files")->required();
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { finish(run_figures(*options)); });
}

int run_figures(const FiguresOptions& options) {
  bool complete = true;
  for (const std::string& file : options.files) {
    const Study study = read_study(file, options.study);
    const StudyResults results = read_results(study, options.results);
    for (const auto& path : draw_figures(study, results)) fmt::print("{}\n", path.string());
    if (results.missing == 0) continue;
    complete = false;
    fmt::print(stderr, "{}: {} of {} jobs are not done; `mpmstudy run {}` runs them\n", study.name,
               results.missing, study.scenes.size(), shell_word(file));
  }
  return complete ? exit_ok : exit_stopped;
}

}  // namespace mpmstudy
