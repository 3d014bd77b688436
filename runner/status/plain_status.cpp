#include "runner/status/plain_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <ostream>

#include "runner/status/eta.hpp"
#include "runner/status/label.hpp"
#include "runner/study/characters.hpp"

namespace mpmstudy {
namespace {

class PlainStatus : public Status {
 public:
  PlainStatus(std::ostream& out, PlainOptions options, StatusClock clock)
      : out_(out), options_(std::move(options)), clock_(std::move(clock)), eta_(0, 1) {}

  void run_started(const RunStart& start) override {
    std::lock_guard lock(mutex_);
    jobs_ = start.jobs;
    finished_ = 0;
    eta_ = Eta(start.predicted_seconds, start.workers);
    started_ = clock_();
    if (!options_.quiet) out_ << start_text(start) << std::flush;
  }

  void jobs_added(std::int64_t jobs, double predicted_seconds) override {
    std::lock_guard lock(mutex_);
    jobs_ += jobs;
    eta_.add(predicted_seconds);
  }

  void job_started(const Job& job) override {
    std::lock_guard lock(mutex_);
    last_[job.key] = clock_();
    if (!options_.quiet)
      out_ << cut_text(fmt::format("{} started: {} particles, about {} steps, {}", short_key(job.key),
                                   job.estimate.particles, job.estimate.steps, label(job)),
                       line_columns)
           << "\n"
           << std::flush;
  }

  void job_progress(const Job& job, const mpm::Progress& p) override {
    std::lock_guard lock(mutex_);
    const double fraction = p.end_time > 0 ? p.time / p.end_time : 0;
    eta_.progress(job.key, job.predicted_seconds, fraction);
    const double now = clock_();
    if (options_.quiet || now - last_[job.key] < options_.progress_every_s) return;
    last_[job.key] = now;
    const auto left = eta_.remaining(now - started_);
    out_ << fmt::format("{} {:3.0f} %, step {}, {:.3f} ns{}\n", short_key(job.key), 100 * fraction, p.step,
                        p.time * 1e9, left ? ", all done in about " + readable_duration(*left) : "")
         << std::flush;
  }

  void job_noted(const Job& job, const std::string& text) override {
    std::lock_guard lock(mutex_);
    out_ << short_key(job.key) << " " << text << "\n" << std::flush;
  }

  void job_finished(const Job& job, const JobEnd& end) override {
    std::lock_guard lock(mutex_);
    last_.erase(job.key);
    if (end.status == JobStatus::planned) {
      eta_.stopped(job.key);  // undecided, so it is not counted
    } else {
      eta_.finished(job.key, job.predicted_seconds);
      ++finished_;
    }
    if (options_.quiet && end.status != JobStatus::failed) return;
    out_ << end_line(finished_, jobs_, job, end, label(job)) << "\n" << std::flush;
  }

  void run_finished(const RunEnd& end) override {
    std::lock_guard lock(mutex_);
    out_ << end_text(end) << std::flush;
  }

 private:
  std::string label(const Job& job) const {
    return options_.label ? options_.label(job) : label_of(job.scene, options_.swept);
  }

  std::ostream& out_;
  PlainOptions options_;
  StatusClock clock_;
  std::mutex mutex_;  // guards what follows, and out_
  Eta eta_;
  double started_ = 0;
  std::int64_t jobs_ = 0, finished_ = 0;
  std::map<std::string, double> last_;  // key -> when its last line was printed
};

}  // namespace

StatusClock steady_status_clock() {
  return [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
}

std::unique_ptr<Status> make_plain_status(std::ostream& out, PlainOptions options, StatusClock clock) {
  return std::make_unique<PlainStatus>(out, std::move(options), std::move(clock));
}

std::string end_line(std::int64_t number, std::int64_t of, const Job& job, const JobEnd& end,
                     const std::string& label) {
  std::string line = fmt::format("[{}/{}] {} ", number, of, short_key(job.key));
  std::string how;
  if (end.status == JobStatus::planned)
    how = "stopped, will be run again" + (end.reason.empty() ? "" : ": " + first_line(end.reason));
  else if (end.status == JobStatus::failed)
    how = "FAILED: " + first_line(end.reason);
  else
    how = fmt::format("done in {} ({} particles, {} steps, {} updates)", readable_duration(end.wall_s),
                      end.particles, end.steps, readable_rate(end.updates_per_second()));
  // What sets the job apart keeps 40 columns beside a long reason.
  constexpr std::size_t label_columns = 40;
  // How fast it went is told where there is room for it.
  if (end.status == JobStatus::done && characters_in(line + how + "  " + label) > line_columns)
    how = "done in " + readable_duration(end.wall_s);
  const std::size_t kept = label.empty() ? 0 : 2 + std::min(characters_in(label), label_columns);
  line += cut_text(how, line_columns - std::min(characters_in(line) + kept, line_columns));
  return cut_text(label.empty() ? line : line + "  " + label, line_columns);
}

std::string start_text(const RunStart& start) {
  std::string text = fmt::format("{}{} to run on {}", start.study.empty() ? "" : start.study + ": ",
                                 counted(start.jobs, "job"), counted(start.workers, "worker"));
  if (start.predicted_seconds > 0)
    text += fmt::format(", about {} of one core",
                        readable_prediction(start.predicted_seconds, start.predicted_factor));
  text += "\n";
  if (start.reused > 0) text += fmt::format("{} done already\n", counted(start.reused, "job"));
  if (start.taken_up > 0)
    text += fmt::format("{} taken up from a process that is gone\n", counted(start.taken_up, "job"));
  if (start.damaged > 0)
    text += fmt::format("{} to run again: a file of fields is missing or damaged\n",
                        counted(start.damaged, "job"));
  if (start.left_failed > 0)
    text += fmt::format("{} failed before, left so; --retry-failed runs failed jobs again\n",
                        counted(start.left_failed, "job"));
  return text;
}

std::string end_text(const RunEnd& end) {
  std::string text =
      fmt::format("{} done, {} failed, {} reused, {} left", end.done, end.failed, end.reused, end.left);
  text += fmt::format(" in {}", readable_duration(end.wall_s));
  if (end.updates_per_second > 0)
    text += fmt::format("; {} particle updates on each core", readable_rate(end.updates_per_second));
  text += "\n";
  if (end.predicted_s > 0 && end.cpu_s > 0)
    text +=
        fmt::format("predicted {} of one core, took {}\n",
                    readable_prediction(end.predicted_s, end.predicted_factor), readable_duration(end.cpu_s));
  if (!end.stop_reason.empty()) text += "stopped: " + end.stop_reason + "; run again to go on\n";
  return text;
}

}  // namespace mpmstudy
