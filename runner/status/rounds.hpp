#pragma once
#include <map>
#include <string>

#include "runner/status/status.hpp"

namespace mpmstudy {

/// The rounds of a search, told as one run: one start, jobs that are added, one end with the sums. Every
/// round registers all jobs of its study so far, so the counts of a round hold those of the rounds before it.
/// run_started and run_finished are called from one thread.
class Rounds : public Status {
 public:
  explicit Rounds(Status& status) : status_(status) {}

  void run_started(const RunStart&) override;
  void jobs_added(std::int64_t jobs, double predicted_seconds) override;
  void job_started(const Job&) override;
  void job_progress(const Job&, const mpm::Progress&) override;
  void job_finished(const Job&, const JobEnd&) override;
  /// Tells the end at once where work is left: no round follows.
  void run_finished(const RunEnd&) override;

  /// Tells the end, once; nothing if no round has run.
  void close();

 private:
  Status& status_;
  std::map<std::string, RunEnd> last_;  ///< study -> end of its last round
  std::string study_;                   ///< of the round that runs
  RunEnd sum_;                          ///< of what each round adds
  double updates_ = 0;
  bool closed_ = false;
};

}  // namespace mpmstudy
