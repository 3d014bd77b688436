#include "runner/cli/verify.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <random>

#include "libmpm/scene/physics_version.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/field_files.hpp"
#include "runner/catalog/job_results.hpp"
#include "runner/catalog/output_file.hpp"
#include "runner/catalog/results_of.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/exec/run_studies.hpp"
#include "runner/exec/signals.hpp"
#include "runner/status/label.hpp"
#include "runner/status/plain_status.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// A results folder that is removed when this object is destroyed.
class ScratchFolder {
 public:
  explicit ScratchFolder(const fs::path& results) : path_(unique_name(results / "verify")) {}
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::vector<Job> chosen(const VerifyOptions& options) {
  auto stored = read_jobs(options.results, {"", "done"});
  std::erase_if(stored, [](const StoredJob& job) {
    return job.physics_version != mpm::physics_version_of(job.job.scene);
  });
  std::vector<StoredJob> some;
  std::mt19937_64 random(options.seed != 0 ? options.seed : std::random_device{}());
  std::ranges::sample(stored, std::back_inserter(some), options.jobs, random);
  std::vector<Job> jobs;
  for (auto& job : some) {
    if (job_key(job.job.scene) != job.job.key && former_key(job.job.scene) != job.job.key)
      throw CatalogError("job " + job.job.key + ": its parameters in the catalog do not make its key");
    jobs.push_back(std::move(job.job));
  }
  return jobs;
}

/// Every file of fields against its size and checksum. Gives back how many are not as they were written. A
/// run reads the checksums of files that were touched after their job was done, so those that are wrong are
/// touched.
std::int64_t check_files(const std::string& results) {
  std::int64_t wrong = 0;
  const auto files = all_snapshots(results);
  for (const SnapshotFile& file : files) {
    const fs::path path = fs::path(results) / file.path;
    const auto text = what_is_wrong(path, file.bytes, file.checksum);
    if (text.empty()) continue;
    ++wrong;
    std::error_code gone_or_not_ours;
    fs::last_write_time(path, fs::file_time_type::clock::now(), gone_or_not_ours);
    fmt::print("{}\n", text);
  }
  fmt::print("{} of {} files are as they were written{}\n", static_cast<std::int64_t>(files.size()) - wrong,
             files.size(), wrong > 0 ? "; `mpmstudy run` makes the others again" : "");
  return wrong;
}

}  // namespace

void setup_verify(CLI::App& app, RunSeams given) {
  const auto options = std::make_shared<VerifyOptions>();
  const auto seams = std::make_shared<RunSeams>(std::move(given));
  CLI::App& verb = *app.add_subcommand("verify", "Run done jobs again and compare every bit");
  verb.add_option("N", options->jobs, "How many, chosen at random")
      ->check(CLI::Range(0, 1'000'000))
      ->required();
  verb.add_option("--seed", options->seed, "The same choice again [another one every time]");
  verb.add_option("-j,--jobs", options->workers, "Jobs at a time [processors]")->check(CLI::Range(1, 4096));
  verb.add_flag("--files", options->files, "Compare every file of fields with its checksum, too");
  add_results_option(verb, options->results);
  verb.callback([options, seams] { end_with(run_verify(*options, *seams)); });
}

int run_verify(const VerifyOptions& options, const RunSeams& seams) {
  const auto jobs = chosen(options);
  bool good = !options.files || check_files(options.results) == 0;
  if (jobs.empty() && options.jobs > 0) {
    fmt::print(stderr, "{}: no job is done that this program could run again (physics version {})\n",
               options.results, mpm::physics_version);
    return exit_failed;
  }
  const ScratchFolder scratch(options.results);
  const SignalGuard signals;
  ExecutorOptions executor;
  executor.results = scratch.path();
  executor.workers = static_cast<unsigned>(options.workers);
  const PlannedStudy study{{"verify", jobs, {}, {}, {}}, "", {}};
  {
    CatalogWriter writer(scratch.path());
    Status silent;
    const auto report = run_studies(std::span(&study, 1), false, writer, silent, seams.simulate,
                                    seams.write_snapshot, signal_flag(), executor);
    if (report.left() > 0) return report.exit_code();
  }
  std::size_t same = 0;
  for (const auto& job : jobs) {
    const auto text = difference(results_of(options.results, job.key), results_of(scratch.path(), job.key));
    same += text.empty();
    if (!text.empty()) fmt::print("{}: {}\n", job.key, text);
  }
  fmt::print("{} of {} jobs come out the same to the last bit\n", same, jobs.size());
  return good && same == jobs.size() ? exit_ok : exit_failed;
}

}  // namespace mpmstudy
