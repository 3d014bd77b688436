#include "runner/catalog/process.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace mpmstudy {
namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : "unknown";
}

std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  file >> id;
  return id;
}

std::string link(const std::string& path) {
  std::error_code none;
  return std::filesystem::read_symlink(path, none).string();
}

/// Process numbers and, by an offset, start times belong to a namespace (namespaces(7)). Without a time
/// namespace (Linux before 5.6) there is one time only.
std::string name_space() { return link("/proc/self/ns/pid") + " " + link("/proc/self/ns/time"); }

/// Does /proc show the processes of this one's namespace? Not after `unshare --pid` without a new mount.
bool proc_is_ours() { return link("/proc/self") == std::to_string(getpid()); }

struct Stat {
  bool works = false;      ///< a zombie does not
  std::int64_t start = 0;  ///< clock ticks after boot
};

/// Fields 3 and 22 of /proc/PID/stat (see proc(5)); empty if it cannot be read. The second field, the
/// command, may hold blanks and parentheses: fields are counted from its last ')'.
std::optional<Stat> stat_of(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/stat");
  std::stringstream text;
  text << file.rdbuf();
  const std::string line = text.str();
  const auto end_of_command = line.rfind(')');
  if (end_of_command == std::string::npos) return std::nullopt;
  std::istringstream rest(line.substr(end_of_command + 1));
  Stat stat;
  std::string field;
  for (int i = 3; i <= 22; ++i) {
    rest >> field;
    if (i == 3) stat.works = field != "Z" && field != "X";
  }
  try {
    stat.start = std::stoll(field);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return stat;
}

ProcessId process(std::int64_t pid, const std::string& in_proc) {
  const auto stat = stat_of(in_proc);
  return {host_name(), boot_id(), name_space(), pid, stat ? stat->start : 0};
}

bool can_look(const ProcessId& process) {
  return !process.boot_id.empty() && process.name_space.size() > 1 && process.process_start != 0 &&
         process.host == host_name() && process.boot_id == boot_id() && process.name_space == name_space();
}

}  // namespace

ProcessId this_process() { return process(getpid(), "self"); }

ProcessId process_with(std::int64_t pid) { return process(pid, std::to_string(pid)); }

Liveness liveness(const ProcessId& process) {
  if (!can_look(process)) return Liveness::unknown;
  if (process.pid <= 0) return Liveness::gone;
  if (kill(static_cast<pid_t>(process.pid), 0) != 0 && errno == ESRCH) return Liveness::gone;
  if (!proc_is_ours()) return Liveness::unknown;
  const auto stat = stat_of(std::to_string(process.pid));
  if (!stat) return Liveness::unknown;  // another user's, hidden (hidepid), or it has ended just now
  return stat->works && stat->start == process.process_start ? Liveness::alive : Liveness::gone;
}

}  // namespace mpmstudy
