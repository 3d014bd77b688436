#include "runner/catalog/runner_row.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include "runner/catalog/process.hpp"
#include "runner/catalog/timestamp.hpp"

namespace mpmstudy {

RunnerRow runner_row(SQLite::Statement& row, int first, const std::string& now, double heartbeat_expires_s) {
  const ProcessId process{row.getColumn(first).getString(), row.getColumn(first + 1).getString(),
                          row.getColumn(first + 2).getInt64(), row.getColumn(first + 3).getInt64()};
  const auto gone = [&] {
    if (!row.isColumnNull(first + 5)) return true;  // it said so itself
    const auto state = liveness(process);
    if (state != Liveness::unknown) return state == Liveness::gone;
    return seconds_between(row.getColumn(first + 4).getString(), now) > heartbeat_expires_s;
  };
  return {process.host + ":" + std::to_string(process.pid), gone()};
}

}  // namespace mpmstudy
