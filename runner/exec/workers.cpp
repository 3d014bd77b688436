#include "runner/exec/workers.hpp"

#include <algorithm>
#include <utility>

namespace mpmstudy {

ThreadWorkers::ThreadWorkers(const Simulate& simulate, const WriteSnapshot& write, Ledger& ledger,
                             Status& status, StopFlag& flag, ExecutorOptions options)
    : simulate_(simulate),
      write_(write),
      ledger_(ledger),
      status_(status),
      flag_(flag),
      options_(std::move(options)) {}

ExecutorReport ThreadWorkers::run(std::vector<Job> jobs,
                                  const std::function<void(const ExecutorReport&)>& abandoned) {
  ExecutorOptions options = options_;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
  if (options.budget_s > 0) options.budget_s = std::max(1e-9, options.budget_s - spent.count());
  if (options_.abandon)
    options.abandon = [&](const ExecutorReport& executed) {
      abandoned(executed);
      options_.abandon(executed);
    };
  return execute_jobs(std::move(jobs), simulate_, write_, ledger_, status_, flag_, options);
}

unsigned ThreadWorkers::count(std::size_t jobs) const { return worker_count(options_, jobs); }

}  // namespace mpmstudy
