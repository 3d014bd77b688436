#include "runner/cli/retry.hpp"

#include <SQLiteCpp/Database.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/store.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {

void setup_retry(CLI::App& app) {
  const auto options = std::make_shared<RetryOptions>();
  CLI::App& verb = *app.add_subcommand("retry", "Plan failed jobs again");
  verb.add_option("KEY", options->keys, "Keys of jobs, or their first digits [every failed job]");
  verb.add_option("--study", options->filter.study, "Jobs of this study only")->type_name("NAME");
  verb.add_option("--kind", options->filter.kind, "Only those that failed so")
      ->check(CLI::IsMember({"breakdown", "timeout", "memory", "crash", "error"}));
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_retry(*options)); });
}

int run_retry(const RetryOptions& options) {
  if (std::ranges::find(options.keys, "") != options.keys.end())  // a variable of the shell that is not set
    throw StudyError("KEY: is empty; without any key, every failed job is planned again");
  // Throws if there is no catalog, or no such study.
  if (options.filter.study.empty())
    open_for_reading(options.results);
  else
    read_state(options.results, {options.filter.study});
  StoreOptions store_options;
  store_options.git_revision = git_revision();
  Store store(options.results, store_options);
  store.begin();
  std::vector<std::string> planned;
  bool all_found = true;
  for (const auto& key : options.keys.empty() ? std::vector<std::string>{""} : options.keys) {
    auto filter = options.filter;
    filter.key_begins = key;
    const auto keys = store.retry(filter);
    if (keys.empty() && !key.empty()) {
      fmt::print(stderr, "{}: there is no such failed job\n", key);
      all_found = false;
    }
    planned.insert(planned.end(), keys.begin(), keys.end());
  }
  store.leave();
  store.commit();
  for (const auto& key : planned) fmt::print("{} planned again\n", short_key(key));
  fmt::print("{} planned again; `mpmstudy run STUDY` runs them\n",
             counted(static_cast<std::int64_t>(planned.size()), "job"));
  return all_found ? exit_ok : exit_failed;
}

}  // namespace mpmstudy
