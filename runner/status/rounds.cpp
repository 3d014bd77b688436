#include "runner/status/rounds.hpp"

#include <algorithm>

namespace mpmstudy {

void Rounds::run_started(const RunStart& start) {
  const bool first = last_.empty();
  study_ = start.study;
  last_[study_];
  if (first)
    status_.run_started(start);
  else if (start.jobs > 0)
    status_.jobs_added(start.jobs, start.predicted_seconds);
}

void Rounds::jobs_added(std::int64_t jobs, double predicted_seconds) {
  status_.jobs_added(jobs, predicted_seconds);
}

void Rounds::job_started(const Job& job) { status_.job_started(job); }

void Rounds::job_progress(const Job& job, const mpm::Progress& progress) {
  status_.job_progress(job, progress);
}

void Rounds::job_finished(const Job& job, const JobEnd& end) { status_.job_finished(job, end); }

void Rounds::run_finished(const RunEnd& end) {
  last_[study_] = end;
  sum_.done += end.done;
  sum_.wall_s += end.wall_s;
  sum_.cpu_s += end.cpu_s;
  sum_.predicted_s += end.predicted_s;
  sum_.predicted_factor = std::max(sum_.predicted_factor, end.predicted_factor);
  sum_.stop_reason = end.stop_reason;
  updates_ += end.updates_per_second * end.cpu_s;
  if (end.left > 0) close();
}

void Rounds::close() {
  if (closed_ || last_.empty()) return;
  closed_ = true;
  RunEnd end = sum_;
  std::int64_t known = 0;  // done now or before
  for (const auto& [study, last] : last_) {
    known += last.done + last.reused;
    end.failed += last.failed;
    end.left += last.left;
  }
  end.reused = known - end.done;
  if (end.cpu_s > 0) end.updates_per_second = updates_ / end.cpu_s;
  status_.run_finished(end);
}

}  // namespace mpmstudy
