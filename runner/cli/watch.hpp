#pragma once
/// `mpmstudy watch [STUDY...]`: `status`, again and again, until nothing is running or planned, or until
/// nobody is there to run what is. Reads only.
#include "runner/cli/status.hpp"

namespace mpmstudy {

struct WatchOptions {
  StatusOptions status;
  double every_s = 2;
  bool wait = false;      ///< also for somebody who runs what is planned
  double patience_s = 5;  ///< how long nobody has to be there
};

void setup_watch(CLI::App&);
/// Ends with the exit code of `status`. Throws as run_status does.
int run_watch(const WatchOptions&);

}  // namespace mpmstudy
