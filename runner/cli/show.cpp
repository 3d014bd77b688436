#include "runner/cli/show.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "runner/cli/json_results.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/cli/missing.hpp"
#include "runner/cli/print_failures.hpp"
#include "runner/cli/print_results.hpp"
#include "runner/cli/skipped_points.hpp"
#include "runner/cli/surface_text.hpp"
#include "runner/finish/study_results.hpp"

namespace mpmstudy {
void setup_show(CLI::App& app) {
  const auto options = std::make_shared<ShowOptions>();
  CLI::App& verb = *app.add_subcommand("show", "Print what studies have come to: results and fits");
  verb.add_option("STUDY", options->studies, "Names of studies, or study files")->required();
  verb.add_flag("--json", options->json, "One JSON object, SI units, full precision, every job");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_show(*options)); });
}

int run_show(const ShowOptions& options) {
  std::vector<Study> studies;
  int code = exit_ok;
  for (const std::string& name : options.studies) {
    const StudyForm form = form_named(name, options.study, options.results);
    studies.push_back(read_study(form.path, form.options));
    const Study& study = studies.back();
    code =
        std::max(code, say_what_is_missing(study, read_results(study, options.results),
                                           form.path + options_text(form.options.set, form.options.cells)));
    if (options.json) continue;
    if (study.search)
      fmt::print("\n{}: {}\n{}{}{}", study.name, study.title, brackets_text(study, options.results),
                 failures_text(study, options.results), fits_text(study, options.results));
    else
      fmt::print("{}", results_text(study, options.results));
    fmt::print("{}{}", tolerance_text(study, options.results), skipped_text(study));
  }
  if (options.json) fmt::print("{}\n", results_json(studies, options.results, code));
  return code;
}

}  // namespace mpmstudy
