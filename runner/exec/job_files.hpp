#pragma once
/// The files of one job: results/fields/KEY/003_2.200ns.vtkhdf. One worker owns them at a time.
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "libmpm/simulation.hpp"
#include "runner/catalog/field_files.hpp"
#include "runner/catalog/records.hpp"
#include "runner/exec/job_checkpoint.hpp"

namespace mpmstudy {

/// Beside the snapshots of a job that is done: opens them in ParaView as one series in time.
inline constexpr const char* series_name = "snapshots.vtkhdf.series";

/// Writes one snapshot to a path; the file that has its name afterwards is whole and synced
/// (mpm::write_vtkhdf). Throws on failure.
using WriteSnapshot = std::function<void(const std::filesystem::path&, const mpm::Snapshot&)>;

/// A file cannot be written: not the job's fault, so the job is planned again and the run stops.
class StorageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class JobFiles {
 public:
  /// What an earlier attempt may have left is removed, unless there is a checkpoint of it, and `go_on`.
  /// Throws StorageError.
  JobFiles(std::filesystem::path results, const std::string& key, WriteSnapshot, bool go_on = false);

  /// From which the run goes on, if it does.
  JobCheckpoint* checkpoint() { return checkpoint_ ? &*checkpoint_ : nullptr; }
  /// Why the run begins anew although there is a checkpoint; "": it does not, or there is none.
  const std::string& why_anew() const { return why_anew_; }
  /// The run begins anew. Throws StorageError.
  void forget_checkpoint() { clear(); }
  /// Throws StorageError.
  void write_checkpoint(const mpm::Record&, double wall_s, double cpu_s);

  /// Throws StorageError.
  void add(const mpm::Snapshot&);
  /// The folder's names reach the disk; gives back every file with size and checksum. Throws StorageError.
  std::vector<SnapshotFile> close();
  /// The attempt is given up: nothing of it stays, unless it can be gone on with from a checkpoint.
  void discard() noexcept;

 private:
  void clear();
  void write_series() const;
  /// Who may write the folder, if this process may not; else "".
  std::string denied() const;

  std::filesystem::path results_, folder_;
  WriteSnapshot write_;
  std::vector<SnapshotFile> files_;
  std::optional<JobCheckpoint> checkpoint_;
  std::string why_anew_;
  bool kept_ = false;  ///< a checkpoint is on disk
};

/// "003_2.200ns.vtkhdf"; a time that is no whole number of picoseconds has as many digits as tell it from
/// others.
std::string snapshot_name(std::size_t index, double time);

}  // namespace mpmstudy
