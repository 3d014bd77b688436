#pragma once
/// How many processors this process may use, which on shared machines is less than the machine has.
#include <filesystem>
#include <string>

namespace mpmstudy {

/// The least of: what the process is bound to (`taskset`, cpusets), what its control groups grant it of
/// processor time (containers, systemd), and inside a Slurm job what the task was given. At least 1.
int usable_processors();

/// Processors' worth of time that control groups grant, rounded up; 0: no bound. `self`: the text of
/// /proc/self/cgroup. `root`: where control groups are mounted. Versions 1 and 2.
int cgroup_processors(const std::string& self, const std::filesystem::path& root);

}  // namespace mpmstudy
