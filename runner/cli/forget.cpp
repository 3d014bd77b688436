#include "runner/cli/forget.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "runner/catalog/reader.hpp"
#include "runner/catalog/store.hpp"
#include "runner/cli/status.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {

void setup_forget(CLI::App& app) {
  const auto options = std::make_shared<ForgetOptions>();
  CLI::App& verb = *app.add_subcommand(
      "forget", "Take studies out of the catalog, with their fits and brackets; jobs stay until gc");
  verb.add_option("STUDY", options->studies, "Names of studies, or study files")->required();
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_forget(*options)); });
}

int run_forget(const ForgetOptions& options) {
  auto names = study_names(options.studies);
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  const CatalogState state = read_state(options.results, names);  // throws if there is no such study
  StoreOptions store_options;
  store_options.git_revision = git_revision();
  Store store(options.results, store_options);
  std::vector<std::int64_t> left_alone;
  store.begin();
  for (const auto& name : names) left_alone.push_back(store.forget(name));
  store.leave();
  store.commit();
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::int64_t jobs = 0;
    for (const auto& study : state.studies)
      if (study.name == names[i])
        for (const auto& [status, number] : study.jobs) jobs += number;
    fmt::print("{} forgotten: {} of its {} no other study has\n", names[i], left_alone[i],
               counted(jobs, "job"));
    std::error_code ignored;
    const auto figures = std::filesystem::path(options.results) / "figures" / names[i];
    if (std::filesystem::exists(figures, ignored)) fmt::print("its figures stay in {}\n", figures.string());
  }
  fmt::print(
      "`mpmstudy gc` removes jobs that no study has; until then a study that wants them has them again\n");
  return exit_ok;
}

}  // namespace mpmstudy
