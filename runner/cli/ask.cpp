#include "runner/cli/ask.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "runner/status/label.hpp"
#include "runner/study/characters.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {
namespace {

/// One number in a file of the kernel; empty: no such file, or it says "max".
std::optional<double> number_in(const std::string& path) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

std::optional<double> available_on_machine() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  double kibibytes = 0;
  while (file >> name >> kibibytes) {
    std::getline(file, unit);
    if (name == "MemAvailable:") return 1024 * kibibytes;
  }
  return std::nullopt;
}

/// Of control groups, versions 2 and 1, as a container sees its own.
std::optional<double> available_in_group() {
  for (const auto& [most, used] : {std::pair("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"),
                                   std::pair("/sys/fs/cgroup/memory/memory.limit_in_bytes",
                                             "/sys/fs/cgroup/memory/memory.usage_in_bytes")}) {
    const auto limit = number_in(most), now = number_in(used);
    if (limit && now) return std::max(0.0, *limit - *now);
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> free_memory() {
  const auto machine = available_on_machine(), group = available_in_group();
  if (machine && group) return std::min(*machine, *group);
  return machine ? machine : group;
}

std::string readable_bytes(double bytes) {
  constexpr const char* units[] = {"B", "kB", "MB", "GB", "TB"};
  std::size_t i = 0;
  for (; i + 1 < std::size(units) && bytes >= 999.5; ++i) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[i]);
}

std::string too_much(const Demand& demand, std::optional<double> free) {
  std::string text;
  if (free && demand.bytes > *free)
    text = fmt::format(
        "about {} of memory, of which {} are free ({})", readable_bytes(demand.bytes), readable_bytes(*free),
        demand.largest > *free ? "the largest job alone takes " + readable_bytes(demand.largest)
                               : "fewer jobs at a time: -j");
  if (demand.wall_seconds > longest_unasked)
    text += fmt::format("{}about {}", text.empty() ? "" : ", and ", readable_duration(demand.wall_seconds));
  return text;
}

void ask(const std::string& too_much) {
  if (too_much.empty()) return;
  if (isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "This will take {}. Go on? [y/N] ", too_much);
    std::string answer;
    std::getline(std::cin, answer);
    if (answer == "y" || answer == "Y" || answer == "yes") return;
    throw StudyError("not started");
  }
  throw StudyError("run: would take " + too_much +
                   "; nothing was started. `mpmstudy plan` has the jobs; a larger cell_size costs less; say "
                   "--yes if that is meant");
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& line : warnings) fmt::print(stderr, "warning: {}\n", printable(line));
}

}  // namespace mpmstudy
