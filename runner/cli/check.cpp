#include "runner/cli/check.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "runner/plan/plan.hpp"

namespace mpmstudy {

void setup_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& verb = *app.add_subcommand("check", "Check study files, and say everything that is wrong");
  verb.add_option("FILE", options->files, "Study files")->required();
  add_study_options(verb, options->study);
  verb.callback([options] { finish(run_check(*options)); });
}

int run_check(const CheckOptions& options) {
  int result = exit_ok;
  for (const std::string& file : options.files) try {
      const Plan plan = make_plan(read_study(file, options.study));
      fmt::print("ok: {}, {} job{}\n", plan.study, plan.jobs.size(), plan.jobs.size() == 1 ? "" : "s");
    } catch (const StudyError& error) {
      fmt::print(stderr, "{}\n", error.what());
      result = exit_usage;
    }
  return result;
}

}  // namespace mpmstudy
