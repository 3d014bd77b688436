#include "runner/catalog/process.hpp"

#include <unistd.h>

#include <array>
#include <fstream>
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

/// Field 22 of /proc/PID/stat (see proc(5)); 0 if there is no such process. The second field, the command,
/// may hold blanks and parentheses: fields are counted from its last ')'. A zombie does no work: gone.
std::int64_t start_of(std::int64_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::stringstream text;
  text << file.rdbuf();
  const std::string line = text.str();
  const auto end_of_command = line.rfind(')');
  if (end_of_command == std::string::npos) return 0;
  std::istringstream rest(line.substr(end_of_command + 1));
  std::string field;
  for (int i = 3; i <= 22; ++i) {
    rest >> field;
    if (i == 3 && (field == "Z" || field == "X")) return 0;
  }
  try {
    return std::stoll(field);
  } catch (const std::exception&) {
    return 0;
  }
}

}  // namespace

ProcessId this_process() { return process_with(getpid()); }

ProcessId process_with(std::int64_t pid) { return {host_name(), boot_id(), pid, start_of(pid)}; }

Liveness liveness(const ProcessId& process) {
  if (process.host != host_name()) return Liveness::unknown;
  if (process.boot_id != boot_id()) return Liveness::gone;
  return start_of(process.pid) == process.process_start && process.process_start != 0 ? Liveness::alive
                                                                                      : Liveness::gone;
}

}  // namespace mpmstudy
