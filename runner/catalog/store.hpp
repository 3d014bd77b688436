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
  /// Runners that cannot look for this process may take its jobs after this silence [s].
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

  /// Enters the jobs of a study and makes them its members, instead of those it had (see Members). Gives back
  /// what is to run. Jobs whose process is gone are planned again; planned jobs that no study has are
  /// cancelled. What the selection does not have is left as it is.
  Registration register_study(const std::string& name, const std::string& title, const std::vector<Job>&,
                              bool retry_failed, const StudySource& = {}, const Selection& = {});

  /// Enters a finer cell under the job at the position `rung.rung_of` of a study, in whose place it becomes
  /// the study's own. Gives back its status; planned: to run.
  JobStatus add_finer(const std::string& study, const Job& rung, bool retry_failed);

  /// planned -> running, by this process. A job that another one runs is taken up if that one is gone.
  JobReservation reserve(const std::string& key);
  /// The child process that ran the job died; gives back how often that has happened, 0 if another process
  /// has taken the job up. Throws CatalogError for a job that this process never ran.
  std::int64_t crashed(const std::string& key);
  /// running -> planned. Nothing happens if another process has taken the job up.
  void release(const std::string& key, const std::string& reason);
  /// running -> done or failed, with everything that belongs to it. False, and nothing is written, if another
  /// process has taken the job up. Both throw CatalogError for a job that this process never ran.
  bool complete(const FinishedJob&);

  void replace_intervals(const std::string& study, const std::vector<IntervalRow>&);
  void replace_fits(const std::string& study, const std::vector<FitRow>&);
  void replace_brackets(const std::string& study, const std::vector<BracketRow>&);

  void replace_claims(const std::vector<Claim>&);

  /// This process lives. Looks whether those live that it has to judge by their signs of life, too.
  void heartbeat();
  /// Does this process run the job? False once another one has taken it up.
  bool holds(const std::string& key);
  /// Jobs that this process runs, as far as it knows, and that another one has taken up.
  std::vector<std::string> lost();
  void leave();  ///< this process ends in order
  /// Moves what is committed from the log into catalog.db, as far as no reader stands in the way, so that a
  /// copy of that file has it. Waits for nobody. Outside of begin() ... commit().
  void move_log() noexcept;

  /// Removes folders of fields whose jobs are neither decided nor running: a process that was killed left
  /// them. Within a transaction, so that nobody begins such a job meanwhile. Gives back how many.
  std::int64_t sweep_files();

  // garbage.cpp
  /// Removes a study with its fits, intervals and brackets. Its jobs stay, planned ones that no other study
  /// has are cancelled. Gives back how many jobs no study has now. Throws CatalogError: there is no such
  /// study, or its jobs are being run.
  std::int64_t forget(const std::string& study);
  /// Removes the rows of jobs that no study has and nobody runs; gives back how many.
  std::int64_t remove_unwanted_jobs();
  /// Removes folders of fields without a job that is wanted. Within a transaction, as sweep_files(), and
  /// after the rows are committed: a file without a row is removed by the next start, a row without its file
  /// would be run again. Gives back what could not be removed, and why.
  std::vector<std::string> remove_unwanted_files();
  /// Gives room that rows have left back to the disk, unless another process uses the catalog. Outside of
  /// begin() ... commit().
  void shrink();

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
