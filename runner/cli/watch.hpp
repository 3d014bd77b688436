#pragma once
/// `mpmstudy watch [STUDY...]`: `status`, again and again, until nothing is running or planned. Reads only.
#include "runner/cli/status.hpp"

namespace mpmstudy {

struct WatchOptions {
  StatusOptions status;
  double every_s = 2;
};

void setup_watch(CLI::App&);
/// Throws as run_status does.
int run_watch(const WatchOptions&);

}  // namespace mpmstudy
