#include "runner/cli/merge.hpp"

#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/store.hpp"
#include "runner/exec/git_revision.hpp"

namespace mpmstudy {

void setup_merge(CLI::App& app) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App& verb = *app.add_subcommand("merge", "Take over the jobs of other results folders");
  verb.add_option("FOLDER", options->folders, "Results folders; they are left as they are")->required();
  add_results_option(verb, options->results);
  verb.callback([options] { finish(run_merge(*options)); });
}

int run_merge(const MergeOptions& options) {
  StoreOptions store_options;
  store_options.git_revision = git_revision();
  Store store(options.results, store_options);
  bool good = true;
  std::int64_t merged = 0, same = 0;
  for (const auto& folder : options.folders) try {
      std::error_code ignored;
      if (std::filesystem::equivalent(folder, options.results, ignored))
        throw CatalogError(folder + ": is the results folder itself");
      const MergeReport report = store.merge(folder);
      merged += report.merged;
      same += report.same;
      for (const auto& text : report.conflicts) fmt::print(stderr, "{}: {}\n", folder, text);
      for (const auto& text : report.damaged) fmt::print(stderr, "{}; its job is left out\n", text);
      good = good && report.conflicts.empty() && report.damaged.empty();
    } catch (const CatalogError& error) {
      fmt::print(stderr, "{}\n", error.what());
      good = false;
    } catch (const SQLite::Exception& error) {
      fmt::print(stderr, "{}: cannot be merged ({})\n", folder, error.what());
      good = false;
    } catch (const std::filesystem::filesystem_error& error) {
      fmt::print(stderr, "{}: cannot be merged ({})\n", folder, error.what());
      good = false;
    }
  store.begin();
  store.leave();
  store.commit();
  fmt::print("{} jobs merged, {} known already\n", merged, same);
  return good ? exit_ok : exit_failed;
}

}  // namespace mpmstudy
