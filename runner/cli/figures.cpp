#include "runner/cli/figures.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "runner/cli/last_run.hpp"
#include "runner/cli/missing.hpp"
#include "runner/finish/figures.hpp"
#include "runner/slurm/shell_word.hpp"

namespace mpmstudy {

void setup_figures(CLI::App& app) {
  const auto options = std::make_shared<FiguresOptions>();
  CLI::App& verb = *app.add_subcommand("figures", "Draw the figures of studies from the catalog");
  verb.add_option("STUDY", options->files, "Study files [every study of the catalog]");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_figures(*options)); });
}

int run_figures(const FiguresOptions& options) {
  bool all_there = true;
  int code = exit_ok;
  for (const StudyForm& form : forms_of(options.files, options.study, options.results, all_there)) {
    const Study study = read_study(form.path, form.options);
    const StudyResults results = read_results(study, options.results);
    if (study.figures.empty() && !options.files.empty())
      fmt::print(stderr, "{}: its file asks for no figure ([[figure]])\n", study.name);
    const auto drawn = draw_figures(study, results);
    for (const auto& path : drawn) fmt::print("{}\n", path.string());
    for (const std::string& line : not_drawn(study, drawn, options.results)) {
      fmt::print(stderr, "{}: {}\n", study.name, line);
      code = std::max(code, exit_failed);
    }
    code = std::max(
        code,
        say_what_is_missing(study, results, form.path + options_text(form.options.set, form.options.cells)));
  }
  return all_there ? code : std::max(code, exit_failed);
}

}  // namespace mpmstudy
