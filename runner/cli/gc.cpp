#include "runner/cli/gc.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/catalog/garbage.hpp"
#include "runner/catalog/store.hpp"
#include "runner/cli/ask.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {
namespace {

std::string garbage_text(const Garbage& garbage) {
  return fmt::format("{} that no study has; {} of fields with {}, {}", counted(garbage.jobs, "job"),
                     counted(std::ssize(garbage.folders), "folder"), counted(garbage.files, "file"),
                     readable_bytes(static_cast<double>(garbage.bytes)));
}

}  // namespace

void setup_gc(CLI::App& app) {
  const auto options = std::make_shared<GcOptions>();
  CLI::App& verb = *app.add_subcommand("gc", "Remove jobs, fields and checkpoints that no study has");
  verb.add_flag("-n,--dry-run", options->dry_run, "Say what would be removed; remove nothing");
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_gc(*options)); });
}

int run_gc(const GcOptions& options) {
  const Garbage garbage = find_garbage(options.results);  // throws if there is no catalog
  if (options.dry_run) {
    for (const auto& folder : garbage.folders) fmt::print("{}\n", folder.string());
    fmt::print("would be removed: {}\n", garbage_text(garbage));
    return exit_ok;
  }
  const std::int64_t before = disk_use(options.results).catalog;
  std::vector<std::string> left;
  {
    StoreOptions store_options;
    store_options.git_revision = git_revision();
    Store store(options.results, store_options);
    store.begin();
    store.remove_unwanted_jobs();
    store.commit();
    store.begin();
    left = store.remove_unwanted_files();
    store.leave();
    store.commit();
    store.shrink();
  }
  const std::int64_t after = disk_use(options.results).catalog;
  for (const auto& text : left) fmt::print(stderr, "cannot be removed: {}\n", text);
  fmt::print("removed: {}; the catalog has {} now, before it had {}\n", garbage_text(garbage),
             readable_bytes(static_cast<double>(after)), readable_bytes(static_cast<double>(before)));
  return left.empty() ? exit_ok : exit_failed;
}

}  // namespace mpmstudy
