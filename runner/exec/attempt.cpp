#include "runner/exec/attempt.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <new>

#include "libmpm/core/thread_clock.hpp"
#include "runner/exec/stopwatch.hpp"

namespace mpmstudy {
namespace {

using Clock = std::chrono::steady_clock;

/// Processor time that is worth a checkpoint when the run is asked to stop [s].
constexpr double worth_saving = 1;

struct Spent {
  double wall_s = 0, cpu_s = 0;
};

/// What the job costs, with what it cost before the checkpoint from which it goes on.
class Spending {
 public:
  void add(const JobCheckpoint& before) { before_ = {before.wall_s, before.cpu_s}; }
  Spent until_now() const {
    return {before_.wall_s + std::chrono::duration<double>(Clock::now() - wall_).count(),
            before_.cpu_s + mpm::thread_cpu_seconds() - cpu_};
  }

 private:
  Clock::time_point wall_ = Clock::now();
  double cpu_ = mpm::thread_cpu_seconds();
  Spent before_;
};

/// Stops one job when asked or when its time is over, hands snapshots to disk, tells how far it is.
class JobObserver : public mpm::Observer {
 public:
  JobObserver(const AttemptContext& context, JobFiles& files, const Spending& spent)
      : context_(context), files_(files), spent_(spent) {}

  bool on_step(const mpm::Progress& progress) override {
    at_ = progress;
    const auto now = Clock::now();
    if (now - told_ >= std::chrono::milliseconds(50)) {
      told_ = now;
      context_.progress(progress);
    }
    const double limit = context_.limits.seconds;
    const double seconds = watch_.seconds();
    late_ = limit > 0 && seconds > limit;
    return !late_ && !context_.stopping();
  }
  int threads() override { return context_.threads(); }
  void on_snapshot(const mpm::Snapshot& snapshot) override { files_.add(snapshot); }

  mpm::Record* resume_from() override { return files_.checkpoint() ? &files_.checkpoint()->run : nullptr; }
  bool wants_checkpoint() override {
    if (context_.checkpoint_s <= 0 || context_.lost()) return false;
    const double since = mpm::thread_cpu_seconds() - saved_;
    return since > context_.checkpoint_s || (since > worth_saving && context_.stopping());
  }
  void on_checkpoint(const mpm::Record& run) override {
    const Spent spent = spent_.until_now();
    files_.write_checkpoint(run, spent.wall_s, spent.cpu_s);
    saved_ = mpm::thread_cpu_seconds();
  }

  bool late() const { return late_; }
  const mpm::Progress& at() const { return at_; }

 private:
  const AttemptContext& context_;
  JobFiles& files_;
  const Spending& spent_;
  double saved_ = mpm::thread_cpu_seconds();  // when
  Stopwatch watch_;
  Clock::time_point told_{};
  mpm::Progress at_{};
  bool late_ = false;
};

/// A result that says why there is none, and where the run was.
void fail(FinishedJob& job, FailureKind kind, const std::string& reason, const mpm::Progress& at) {
  job.failure = kind;
  job.result = {};
  job.result.status = mpm::RunStatus::failed;
  job.result.reason = fmt::format("{} (step {}, t = {} s)", reason, at.step, at.time);
  job.result.particles = at.particles;
  job.result.steps = at.step;
}

/// A breakdown is a value; whatever a simulation throws is made one.
void simulate(const Job& job, const AttemptContext& context, JobFiles& files, const Spending& spent,
              FinishedJob& finished) {
  JobObserver observer(context, files, spent);
  try {
    try {
      finished.result = context.simulate(job.scene, observer);
    } catch (const mpm::InputError& error) {
      if (!files.checkpoint()) throw;
      context.note(fmt::format("begins anew, since its checkpoint does not fit: {}", error.what()));
      files.forget_checkpoint();  // it is of another scene or program: from the start, then
      finished.result = context.simulate(job.scene, observer);
    }
    if (observer.late())
      fail(finished, FailureKind::timeout, fmt::format("ran longer than {} s", context.limits.seconds),
           observer.at());
    else if (finished.result.status == mpm::RunStatus::failed)
      finished.failure = FailureKind::breakdown;
  } catch (const StorageError&) {
    throw;
  } catch (const std::bad_alloc&) {
    fail(finished, FailureKind::memory,
         context.limits.memory > 0 ? fmt::format("needs more than {:g} MB of memory",
                                                 1e-6 * static_cast<double>(context.limits.memory))
                                   : "out of memory",
         observer.at());
  } catch (const std::exception& error) {
    fail(finished, FailureKind::error, error.what(), observer.at());
  } catch (...) {
    fail(finished, FailureKind::error, "an exception that is not a std::exception", observer.at());
  }
}

}  // namespace

Attempt attempt_job(const Job& job, const AttemptContext& context) {
  Spending spent;
  Attempt attempt;
  FinishedJob& finished = attempt.job;
  finished.key = job.key;
  try {
    JobFiles files(context.results, job.key, context.write, context.checkpoint_s > 0);
    if (files.checkpoint()) spent.add(*files.checkpoint());
    if (!files.why_anew().empty()) context.note("begins anew: " + files.why_anew());
    simulate(job, context, files, spent, finished);
    if (finished.result.status == mpm::RunStatus::stopped) {
      if (!context.lost()) files.discard();
      attempt.end = Attempt::End::stopped;
      return attempt;
    }
    finished.snapshots = files.close();
  } catch (const StorageError& error) {
    attempt.end = Attempt::End::storage;
    attempt.why = error.what();
    return attempt;
  }
  const auto [wall_s, cpu_s] = spent.until_now();
  finished.wall_s = wall_s;
  finished.cpu_s = cpu_s + finished.result.helper_seconds;
  finished.status = finished.failure ? JobStatus::failed : JobStatus::done;
  finished.reason = finished.result.reason;
  if (finished.failure && finished.reason.empty()) finished.reason = "failed without a reason";
  return attempt;
}

}  // namespace mpmstudy
