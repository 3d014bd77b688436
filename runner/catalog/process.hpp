#pragma once
/// Who runs a job: enough to tell, later and from another process, whether it still does.
#include <cstdint>
#include <string>

namespace mpmstudy {

struct ProcessId {
  std::string host;
  std::string boot_id;  ///< of the kernel; a reboot ends every process
  /// The namespaces in which the two numbers below mean something: "pid:[4026531836] time:[4026531834]".
  std::string name_space;
  std::int64_t pid = 0;            ///< may be reused by the system,
  std::int64_t process_start = 0;  ///< so: clock ticks after boot at which it started

  bool operator==(const ProcessId&) const = default;
};

ProcessId this_process();
/// A process of this host and of the namespaces of this process.
ProcessId process_with(std::int64_t pid);

enum class Liveness { alive, gone, unknown };

/// Looks for the process by its number. unknown: this process cannot look, since the other one is of another
/// host, another boot or another namespace (numbers mean something else there), or since /proc hides it.
Liveness liveness(const ProcessId&);

}  // namespace mpmstudy
