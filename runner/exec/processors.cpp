#include "runner/exec/processors.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>
#include <vector>

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// Quota over period of one group, from "QUOTA PERIOD" or two files; 0: no bound ("max", -1, no file).
double granted(std::istream&& quota, std::istream&& period) {
  double q = 0, p = 0;
  return quota >> q && period >> p && q > 0 && p > 0 ? q / p : 0;
}

double granted_in(const fs::path& group) {
  std::ifstream both(group / "cpu.max");
  if (double q = 0, p = 0; both >> q >> p && q > 0 && p > 0) return q / p;
  return granted(std::ifstream(group / "cpu.cfs_quota_us"), std::ifstream(group / "cpu.cfs_period_us"));
}

/// A number of the environment, > 0; 0: there is none. "16(x2)" is 16.
int number_of(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::max(0, std::atoi(text));
}

int bound_processors() {
  // A machine may have more processors than cpu_set_t has places.
  for (int most = 1024; most <= 1 << 20; most *= 2) {
    cpu_set_t* set = CPU_ALLOC(static_cast<std::size_t>(most));
    const std::size_t size = CPU_ALLOC_SIZE(static_cast<std::size_t>(most));
    const int count = set != nullptr && sched_getaffinity(0, size, set) == 0 ? CPU_COUNT_S(size, set) : 0;
    CPU_FREE(set);
    if (count > 0) return count;
  }
  return static_cast<int>(std::thread::hardware_concurrency());
}

int slurm_processors() {
  if (std::getenv("SLURM_JOB_ID") == nullptr) return 0;
  const int of_task = number_of("SLURM_CPUS_PER_TASK");
  return of_task > 0 ? of_task : number_of("SLURM_CPUS_ON_NODE");
}

}  // namespace

int cgroup_processors(const std::string& self, const fs::path& root) {
  double least = 0;
  std::istringstream lines(self);
  for (std::string line; std::getline(lines, line);) {  // "0::/a/b" or "4:cpu,cpuacct:/a/b"
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    std::vector<fs::path> mounts;
    if (controllers.empty())
      mounts = {root, root / "unified"};
    else if (("," + controllers + ",").find(",cpu,") != std::string::npos)
      mounts = {root / controllers, root / "cpu"};
    const fs::path path = fs::path(line.substr(second + 1)).relative_path();
    for (const auto& mount : mounts)
      for (fs::path group = path;; group = group.parent_path()) {  // every group above bounds it, too
        const double here = granted_in(mount / group);
        if (here > 0 && (least == 0 || here < least)) least = here;
        if (group.empty()) break;
      }
  }
  return static_cast<int>(std::min(std::ceil(least), 1e6));
}

int usable_processors() {
  std::ifstream file("/proc/self/cgroup");
  const std::string self{std::istreambuf_iterator<char>(file), {}};
  int count = std::max(1, bound_processors());
  for (const int bound : {cgroup_processors(self, "/sys/fs/cgroup"), slurm_processors()})
    if (bound > 0) count = std::min(count, bound);
  return count;
}

}  // namespace mpmstudy
