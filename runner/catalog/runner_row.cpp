#include "runner/catalog/runner_row.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include "runner/catalog/process.hpp"
#include "runner/catalog/timestamp.hpp"

namespace mpmstudy {

RunnerRow runner_row(SQLite::Statement& row, int first, const std::string& now, double heartbeat_expires_s) {
  const ProcessId process{row.getColumn(first).getString(), row.getColumn(first + 1).getString(),
                          row.getColumn(first + 2).getInt64(), row.getColumn(first + 3).getInt64()};
  const auto gone = [&]() -> std::string {
    if (!row.isColumnNull(first + 5)) return "its process has ended";
    switch (liveness(process)) {
      case Liveness::alive:
        return "";
      case Liveness::gone:
        return "its process has gone";
      case Liveness::unknown:
        break;
    }
    const bool silent = seconds_between(row.getColumn(first + 4).getString(), now) > heartbeat_expires_s;
    return silent ? "its host has been silent for too long" : "";
  };
  return {process.host + ":" + std::to_string(process.pid), gone()};
}

}  // namespace mpmstudy
