#pragma once
/// The one writer of a catalog: a thread with a queue. Any thread may call any member; values are handed over
/// and committed in the order of the calls, many in one transaction when many wait.
///
/// Calls that answer wait for their commit. release() does not: what goes wrong there (a full disk) is thrown
/// by the next call or by flush(), and the writer takes nothing more.
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/catalog/store.hpp"
#include "runner/exec/ledger.hpp"

namespace mpmstudy {

struct WriterOptions {
  StoreOptions store;
  /// Period at which the catalog is told that this process lives, and asked whether others do. Longer than a
  /// quarter of StoreOptions::heartbeat_expires_s and other machines may take its jobs.
  std::chrono::milliseconds heartbeat{5000};
  /// Period at which catalog.db itself, without its log, has what is committed; it has all of it at the end.
  std::chrono::milliseconds move_log{60'000};
};

class CatalogWriter : public Ledger {
 public:
  /// Opens results/catalog.db, makes or migrates it. Throws CatalogError.
  explicit CatalogWriter(const std::filesystem::path& results, WriterOptions = {});
  /// Commits what waits, then closes. Errors end here: call flush() first to see them.
  ~CatalogWriter() override;

  Registration register_study(const std::string& name, const std::string& title, std::vector<Job>,
                              bool retry_failed, StudySource = {}, Selection = {});
  JobReservation reserve(const std::string& key) override;
  std::int64_t crashed(const std::string& key) override;
  bool complete(FinishedJob) override;
  void release(const std::string& key, const std::string& reason) override;
  bool lost(const std::string& key) const override;
  bool holds(const std::string& key) override;
  void flush() override;

  /// See Store::sweep_files.
  std::int64_t sweep_files();

  /// One more cell under the job at `rung.rung_of` of a registered study, finer than those it has: from now
  /// on the study's own job there. Gives back what it is; planned: to run.
  JobStatus add_finer(const std::string& study, const Job& rung, bool retry_failed);
  /// Intervals of a registered study, instead of those it had.
  void replace_intervals(const std::string& study, std::vector<IntervalRow>);
  /// Fits of a registered study, instead of those it had.
  void replace_fits(const std::string& study, std::vector<FitRow>);
  /// Brackets of a registered study, instead of those it had.
  void replace_brackets(const std::string& study, std::vector<BracketRow>);
  /// Statements of a publication, judged, instead of those that were there.
  void replace_claims(std::vector<Claim>);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mpmstudy
