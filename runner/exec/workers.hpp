#pragma once
/// Who runs the jobs of a round: threads of this process (with processes of their own for jobs that need
/// one), or, in cli/run_slurm.cpp, a cluster.
#include <chrono>
#include <functional>
#include <vector>

#include "runner/exec/executor.hpp"

namespace mpmstudy {

class Workers {
 public:
  virtual ~Workers() = default;
  /// Runs them, or has others run them. With work left the run ends for now. `abandoned` is called with what
  /// was done before the process ends itself, see ExecutorOptions::abandon.
  virtual ExecutorReport run(std::vector<Job>,
                             const std::function<void(const ExecutorReport&)>& abandoned) = 0;
  /// How many jobs at a time.
  virtual unsigned count(std::size_t jobs) const = 0;
};

class ThreadWorkers : public Workers {
 public:
  /// The budget is that of all rounds together, from now on. All must outlive this.
  ThreadWorkers(const Simulate&, const WriteSnapshot&, Ledger&, Status&, StopFlag&, ExecutorOptions);
  ExecutorReport run(std::vector<Job>, const std::function<void(const ExecutorReport&)>& abandoned) override;
  unsigned count(std::size_t jobs) const override;

 private:
  const Simulate& simulate_;
  const WriteSnapshot& write_;
  Ledger& ledger_;
  Status& status_;
  StopFlag& flag_;
  ExecutorOptions options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace mpmstudy
