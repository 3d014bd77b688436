#pragma once
/// The transactions of the catalog, as plain calls. One thread only: CatalogWriter's. Every call but begin()
/// happens between begin() and commit(); SQLite's exceptions come through.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runner/catalog/process.hpp"
#include "runner/catalog/records.hpp"
#include "runner/catalog/runner_row.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {

struct StoreOptions {
  std::string git_revision;  ///< of the program that writes
  /// A runner of another host that is silent for longer is gone [s].
  double heartbeat_expires_s = default_heartbeat_expires_s;
  ProcessId process = this_process();
};

class Store {
 public:
  /// Opens the catalog (see open_for_writing) and enters this process as a runner. Throws CatalogError.
  Store(const std::filesystem::path& results, StoreOptions);
  ~Store();

  void begin();  ///< takes the write lock, waits for it if need be
  void commit();
  void rollback();

  /// A part of the transaction that can fail alone.
  void begin_part();
  void commit_part();
  void rollback_part();

  /// Enters the jobs of a study and makes them its members, instead of those it had. Gives back what is to
  /// run. Jobs whose process is gone are planned again; planned jobs that no study has are cancelled.
  Registration register_study(const std::string& name, const std::string& title, const std::vector<Job>&,
                              bool retry_failed, const StudySource& = {});

  /// Enters a finer cell under the job at the position `rung.rung_of` of a study, in whose place it becomes
  /// the study's own. Gives back its status; planned: to run.
  JobStatus add_finer(const std::string& study, const Job& rung, bool retry_failed);

  /// planned -> running, by this process. A job that another one runs is taken up if that one is gone.
  JobClaim claim(const std::string& key);
  /// The child process that ran the job died; gives back how often its process has. Throws CatalogError if
  /// this process does not run the job.
  std::int64_t crashed(const std::string& key);
  /// running -> planned. Nothing happens if another process has taken the job up.
  void release(const std::string& key, const std::string& reason);
  /// running -> done or failed, with everything that belongs to it. False, and nothing is written, if another
  /// process has taken the job up. Both throw CatalogError for a job that this process never ran.
  bool finish(const FinishedJob&);

  void replace_intervals(const std::string& study, const std::vector<IntervalRow>&);
  void replace_fits(const std::string& study, const std::vector<FitRow>&);
  void replace_brackets(const std::string& study, const std::vector<BracketRow>&);

  void replace_claims(const std::vector<Claim>&);

  void heartbeat();  ///< this process lives
  void leave();      ///< this process ends in order

  /// Removes folders of fields whose jobs are neither decided nor running: a process that was killed left
  /// them. Within a transaction, so that nobody begins such a job meanwhile. Gives back how many.
  std::int64_t sweep_files();

  /// failed -> planned for all that the filter names; gives back their keys.
  std::vector<std::string> retry(const RetryFilter&);

  /// Takes over every decided job of another catalog, with its files: the one in this results folder. A job
  /// that both have done is compared. Merging again changes nothing. Has a transaction of its own: call it
  /// outside of begin() ... commit(). Throws CatalogError for a folder that cannot be merged.
  MergeReport merge(const std::filesystem::path& results);

  struct Impl;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace mpmstudy
