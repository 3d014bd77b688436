#include "runner/cli/merge.hpp"

#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <system_error>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/store.hpp"
#include "runner/exec/git_revision.hpp"

namespace mpmstudy {
namespace {

/// The file is no whole database, and will be none the next time either. What else SQLite says (a full disk,
/// a lock, a read error) is of the moment.
bool is_damaged(const SQLite::Exception& error) {
  const int code = error.getErrorCode() & 0xff;
  return code == SQLITE_NOTADB || code == SQLITE_CORRUPT;
}

}  // namespace

void setup_merge(CLI::App& app) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App& verb = *app.add_subcommand("merge", "Take over the jobs of other results folders");
  verb.add_option("FOLDER", options->folders, "Results folders; they are left as they are")->required();
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_merge(*options)); });
}

int run_merge(const MergeOptions& options) {
  StoreOptions store_options;
  store_options.git_revision = git_revision();
  Store store(options.results, store_options);
  bool good = true, left = false;
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
      if (is_damaged(error))
        good = false;
      else
        left = true;
    } catch (const std::system_error& error) {
      fmt::print(stderr, "{}: cannot be merged ({})\n", folder, error.what());
      left = true;
    }
  store.begin();
  store.leave();
  store.commit();
  fmt::print("{} jobs merged, {} known already\n", merged, same);
  if (left) fmt::print(stderr, "not all is merged; run it again to go on\n");
  return left ? exit_stopped : good ? exit_ok : exit_failed;
}

}  // namespace mpmstudy
