// Faults by force, and a look at what they leave. See README.md.
//
//   fault_harness --kills 300 [--seed S] [--program FILE] [--study FILE] [--folder DIR]
//   fault_harness --disk 100 [--every 7]
//   fault_harness --read-only
//   fault_harness --disturb 300 [--seed S]
//   fault_harness --compare RESULTS RESULTS
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "tests/faults/harness.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy::faults {
namespace {

namespace fs = std::filesystem;
constexpr int skipped = 77;

int compare(const fs::path& one, const fs::path& other) {
  const bool same = rows_of(one) == rows_of(other);
  fmt::print("{} and {}: {}\n", one.string(), other.string(),
             same ? "the same to the last bit" : "different");
  return same ? 0 : 1;
}

/// No permission holds for root. False if the program cannot be run as anybody else.
bool become_nobody(const Options& options) {
  if (geteuid() != 0) return true;
  constexpr uid_t nobody = 65534;
  if (chown(options.folder.c_str(), nobody, nobody) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0)
    return false;
  return access(options.program.c_str(), X_OK) == 0 && access(options.study.c_str(), R_OK) == 0 &&
         access(options.folder.c_str(), W_OK) == 0;
}

int run(const Options& options) {
  fs::create_directories(options.folder);
  if (options.read_only && !become_nobody(options)) {
    fmt::print("skipped: root may write everywhere, and nobody else may run {}\n", options.program);
    return skipped;
  }
  const Undisturbed expected = run_undisturbed(options);
  if (options.read_only) return lock_folders(options, expected);
  if (options.disturb > 0) return disturb_runs(options, expected);
  return options.disk > 0 ? fail_disks(options, expected) : kill_runs(options, expected);
}

}  // namespace
}  // namespace mpmstudy::faults

int main(int argc, char** argv) {
  using namespace mpmstudy::faults;
  Options options;
  options.folder = (fs::temp_directory_path() / fmt::format("mpmstudy-faults-{}", getpid())).string();
  CLI::App app("Disturbs runs by force and looks for damage");
  app.add_option("--kills", options.kills, "How many processes to kill")->capture_default_str();
  app.add_option("--disk", options.disk, "Instead: how many failures of the disk, of each kind");
  app.add_option("--every", options.every, "Changes of the disk between two failures")->capture_default_str();
  app.add_flag("--read-only", options.read_only, "Instead: folders that cannot be written");
  app.add_option("--disturb", options.disturb,
                 "Instead: how many signals, to one runner, two, two hosts and two namespaces");
  app.add_option("--seed", options.seed, "Of the moments")->capture_default_str();
  app.add_option("--program", options.program, "mpmstudy")->capture_default_str();
  app.add_option("--study", options.study, "Study file")->capture_default_str();
  app.add_option("--folder", options.folder, "For its results")->capture_default_str();
  app.add_option("--compare", options.compare, "Only compare the catalogs of two results folders")
      ->expected(2);
  CLI11_PARSE(app, argc, argv);
  try {
    if (!options.compare.empty()) return compare(options.compare[0], options.compare[1]);
    const int code = run(options);
    if (code == 0 || code == skipped) fs::remove_all(options.folder);
    return code;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
