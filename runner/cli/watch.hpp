#pragma once
/// `mpmstudy watch [STUDY...]`: `status`, again and again, until nothing is running or planned, or until
/// no process is left that runs it. Reads only.
#include "runner/cli/status.hpp"

namespace mpmstudy {

struct WatchOptions {
  StatusOptions status;
  double every_s = 2;
  bool wait = false;      ///< also for a process that runs what is planned
  double patience_s = 5;  ///< after so long without such a process it ends [s]
};

void setup_watch(CLI::App&);
/// Ends with the exit code of `status`. Throws as run_status does.
int run_watch(const WatchOptions&);

}  // namespace mpmstudy
