#include "runner/cli/check.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "runner/cli/ask.hpp"
#include "runner/cli/skipped_points.hpp"
#include "runner/plan/warnings.hpp"
#include "runner/status/label.hpp"
#include "runner/study/characters.hpp"

namespace mpmstudy {

void setup_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& verb = *app.add_subcommand("check", "Check study files, and say everything that is wrong");
  verb.add_option("FILE", options->files, "Study files")->required();
  add_study_options(verb, options->study);
  verb.callback([options] { end_with(run_check(*options)); });
}

int run_check(const CheckOptions& options) {
  int result = exit_ok;
  for (const std::string& file : options.files) try {
      const Study study = read_study(file, options.study);
      const Plan plan = make_plan(study);
      const auto jobs = first_jobs(plan);
      print_warnings(warnings_of(study, plan));
      fmt::print("ok: {}, {}, about {} of memory each and {:.2g} CPU-hours{}\n", plan.study,
                 counted(static_cast<std::int64_t>(plan.jobs.size()), "job"),
                 readable_bytes(demand_of(jobs, 1).bytes), cpu_seconds(jobs) / 3600,
                 study.search ? " for the lower end of its search" : "");
      fmt::print("{}", skipped_text(study));
    } catch (const StudyError& error) {
      fmt::print(stderr, "{}\n", printable_lines(error.what()));
      result = exit_usage;
    }
  return result;
}

}  // namespace mpmstudy
