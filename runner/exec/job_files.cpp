#include "runner/exec/job_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "runner/catalog/field_files.hpp"
#include "runner/catalog/file_system.hpp"
#include "runner/catalog/output_file.hpp"

namespace mpmstudy {
namespace fs = std::filesystem;

JobFiles::JobFiles(fs::path results, const std::string& key, WriteSnapshot write, bool go_on)
    : results_(std::move(results)), folder_(fs::path("fields") / key), write_(std::move(write)) {
  if (go_on) checkpoint_ = read_job_checkpoint(results_ / folder_ / checkpoint_name, results_, why_anew_);
  if (checkpoint_) {
    files_ = checkpoint_->files;
    kept_ = true;
  } else {
    clear();
  }
}

void JobFiles::clear() {
  files_.clear();
  checkpoint_.reset();
  kept_ = false;
  std::error_code error;
  fs::remove_all(results_ / folder_, error);
  if (error) throw StorageError((results_ / folder_).string() + ": " + error.message() + denied());
}

void JobFiles::write_checkpoint(const mpm::Record& run, double wall_s, double cpu_s) {
  try {
    fs::create_directories(results_ / folder_);
    write_job_checkpoint(results_ / folder_ / checkpoint_name, {run, files_, wall_s, cpu_s});
    kept_ = true;
  } catch (const std::exception& error) {
    throw StorageError(error.what() + denied());
  }
}

void JobFiles::add(const mpm::Snapshot& snapshot) {
  const fs::path path = folder_ / snapshot_name(files_.size(), snapshot.time);
  try {
    fs::create_directories(results_ / folder_);
    write_(results_ / path, snapshot);
    files_.push_back({snapshot.time, snapshot.step, path.string(),
                      static_cast<std::int64_t>(fs::file_size(results_ / path)), checksum_of(results_ / path),
                      modified_ns(results_ / path)});
  } catch (const StorageError&) {
    throw;
  } catch (const std::exception& error) {
    throw StorageError(error.what() + denied());
  }
}

/// What ParaView opens as one series in time: file names beside this one, and their times [s].
void JobFiles::write_series() const {
  nlohmann::ordered_json series = {{"file-series-version", "1.0"}, {"files", nlohmann::json::array()}};
  for (const SnapshotFile& file : files_)
    series["files"].push_back({{"name", fs::path(file.path).filename().string()}, {"time", file.time}});
  OutputFile file(results_ / folder_ / series_name);
  file.stream() << series.dump(1) << "\n";
  file.commit();
}

std::string JobFiles::denied() const { return who_may_if_denied(results_ / folder_); }

std::vector<SnapshotFile> JobFiles::close() {
  std::error_code ignored;  // a checkpoint that stays is never looked at again
  fs::remove(results_ / folder_ / checkpoint_name, ignored);
  for (const auto& entry :
       fs::directory_iterator(results_ / folder_, ignored))  // unfinished files of a killed process
    if (entry.path().extension() == ".tmp") fs::remove(entry.path(), ignored);
  if (files_.empty()) {
    fs::remove(results_ / folder_, ignored);
    return {};
  }
  try {
    write_series();
    for (const auto& folder : {results_ / folder_, results_ / "fields", results_}) sync_to_disk(folder);
  } catch (const std::exception& error) {
    throw StorageError(error.what());
  }
  return files_;
}

void JobFiles::discard() noexcept {
  if (kept_) return;
  std::error_code ignored;  // what stays is removed by the next attempt
  fs::remove_all(results_ / folder_, ignored);
}

std::string snapshot_name(std::size_t index, double time) {
  const double ns = time * 1e9;
  const bool short_enough = std::abs(ns - std::round(ns * 1e3) * 1e-3) <= 1e-9 * ns;
  return short_enough ? fmt::format("{:03}_{:.3f}ns.vtkhdf", index, ns)
                      : fmt::format("{:03}_{:.9g}ns.vtkhdf", index, ns);
}

}  // namespace mpmstudy
