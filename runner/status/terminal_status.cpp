#include "runner/status/terminal_status.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <ostream>

#include "runner/status/eta.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {
namespace {

/// "[#####.....]": ten places.
std::string bar(double fraction) {
  const auto filled = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * 10);
  return "[" + std::string(filled, '#') + std::string(10 - filled, '.') + "]";
}

class TerminalStatus : public Status {
 public:
  TerminalStatus(std::ostream& out, TerminalOptions options, StatusClock clock)
      : out_(out), options_(std::move(options)), clock_(std::move(clock)), eta_(0, 1) {
    if (!options_.width) options_.width = terminal_width;
  }

  void run_started(const RunStart& start) override {
    std::lock_guard lock(mutex_);
    jobs_ = start.jobs;
    finished_ = 0;
    eta_ = Eta(start.predicted_seconds, start.workers);
    started_ = clock_();
    out_ << start_text(start) << std::flush;
  }

  void jobs_added(std::int64_t jobs, double predicted_seconds) override {
    std::lock_guard lock(mutex_);
    jobs_ += jobs;
    eta_.add(predicted_seconds);
  }

  void job_started(const Job& job) override {
    std::lock_guard lock(mutex_);
    running_.push_back({job.key, label(job), {}});
    redraw(false);
  }

  void job_progress(const Job& job, const mpm::Progress& progress) override {
    std::lock_guard lock(mutex_);
    for (auto& line : running_)
      if (line.key == job.key) line.progress = progress;
    eta_.progress(job.key, job.predicted_seconds, fraction(progress));
    redraw(false);
  }

  void job_noted(const Job& job, const std::string& text) override {
    std::lock_guard lock(mutex_);
    wipe();
    out_ << short_key(job.key) << " " << text << "\n";
    redraw(true);
  }

  void job_finished(const Job& job, const JobEnd& end) override {
    std::lock_guard lock(mutex_);
    std::erase_if(running_, [&](const auto& line) { return line.key == job.key; });
    if (end.status == JobStatus::planned) {
      eta_.stopped(job.key);  // undecided, so it is not counted
    } else {
      eta_.finished(job.key, job.predicted_seconds);
      ++finished_;
    }
    wipe();
    out_ << end_line(finished_, jobs_, job, end, label(job)) << "\n";
    redraw(true);
  }

  void run_finished(const RunEnd& end) override {
    std::lock_guard lock(mutex_);
    wipe();
    out_ << end_text(end) << std::flush;
  }

 private:
  std::string label(const Job& job) const {
    return options_.label ? options_.label(job) : label_of(job.scene, options_.swept);
  }

  struct Line {
    std::string key, label;
    mpm::Progress progress;
  };

  static double fraction(const mpm::Progress& p) { return p.end_time > 0 ? p.time / p.end_time : 0; }

  /// Takes the block away; the cursor stands where it began.
  void wipe() {
    if (drawn_ > 0) out_ << "\x1b[" << drawn_ << "A\r\x1b[J";
    drawn_ = 0;
  }

  /// No line may wrap, or the block would be higher than it was thought: cut to the width, less one.
  void line(const std::string& text, std::size_t width) {
    out_ << text_start(text, width > 1 ? width - 1 : 0) << "\n";
    ++drawn_;
  }

  void redraw(bool now) {
    const double at = clock_();
    if (!now && at - last_draw_ < options_.redraw_every_s) return;
    last_draw_ = at;
    wipe();
    const std::size_t width = options_.width();
    const std::size_t shown = std::min(running_.size(), options_.most_lines);
    for (std::size_t i = 0; i < shown; ++i) {
      const auto& [key, label, p] = running_[i];
      line(fmt::format("{} {} {:3.0f} %  step {:>6}  {:9.3f} ns  {}", short_key(key), bar(fraction(p)),
                       100 * fraction(p), p.step, p.time * 1e9, label),
           width);
    }
    const auto left = eta_.remaining(at - started_);
    line(
        fmt::format("{}/{} jobs {} {:3.0f} %  {} running  {} left", finished_, jobs_, bar(eta_.fraction()),
                    100 * eta_.fraction(), running_.size(), left ? "about " + readable_duration(*left) : "?"),
        width);
    out_ << std::flush;
  }

  std::ostream& out_;
  TerminalOptions options_;
  StatusClock clock_;
  std::mutex mutex_;  // guards what follows, and out_
  Eta eta_;
  double started_ = 0, last_draw_ = -1e9;
  std::int64_t jobs_ = 0, finished_ = 0;
  std::size_t drawn_ = 0;  // lines of the block on the screen
  std::vector<Line> running_;
};

}  // namespace

std::unique_ptr<Status> make_terminal_status(std::ostream& out, TerminalOptions options, StatusClock clock) {
  return std::make_unique<TerminalStatus>(out, std::move(options), std::move(clock));
}

std::size_t terminal_width() {
  winsize size{};
  for (const int stream : {STDERR_FILENO, STDOUT_FILENO})
    if (ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

}  // namespace mpmstudy
