#pragma once
/// Jobs in processes of their own: one that crashes, or that has to be killed, ends no other.
///
/// A program that runs threads cannot safely fork. So a server process is forked before the threads start; it
/// never has more than one thread, and forks for each job a guard, which forks the job and waits for it:
///
///   runner (threads) -- socket --> server -- fork --> guard -- fork --> job
///        ^---------------- socket of this job, shared by guard and job ---'
///
/// The job writes progress and its result to the socket, the guard how the job ended. A process ends
/// when the other end of its socket is closed: when the runner is gone or gives a job up, the guard kills the
/// job.
#include <filesystem>
#include <memory>

#include "runner/exec/attempt.hpp"

namespace mpmstudy {

class JobServer {
 public:
  /// Forks. Call it before the threads of the run start.
  JobServer(const Simulate& simulate, const WriteSnapshot& write, const std::filesystem::path& results);
  ~JobServer();
  JobServer(const JobServer&) = delete;
  JobServer& operator=(const JobServer&) = delete;

  /// Runs the job in a process of its own, within context.limits; waits for it. `simulate`, `write` and
  /// `results` of the context are not used. A job that does not stop in time is killed. Any thread.
  Attempt attempt(const Job&, const AttemptContext&);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mpmstudy
