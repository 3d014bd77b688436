#pragma once
/// Who runs a job: enough to tell, later and from another process, whether it still does.
#include <cstdint>
#include <string>

namespace mpmstudy {

struct ProcessId {
  std::string host;
  std::string boot_id;             ///< of the kernel; a reboot ends every process
  std::int64_t pid = 0;            ///< may be reused by the system,
  std::int64_t process_start = 0;  ///< so: clock ticks after boot at which it started

  bool operator==(const ProcessId&) const = default;
};

ProcessId this_process();
/// A process of this host.
ProcessId process_with(std::int64_t pid);

enum class Liveness { alive, gone, unknown };

/// unknown: it is of another host, where this one cannot look.
Liveness liveness(const ProcessId&);

}  // namespace mpmstudy
