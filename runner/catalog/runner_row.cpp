#include "runner/catalog/runner_row.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include "runner/catalog/process.hpp"

namespace mpmstudy {

RunnerRow runner_row(SQLite::Statement& row, int first, Heartbeats* heartbeats) {
  const auto text = [&](int i) { return row.getColumn(first + i).getString(); };
  const auto integer = [&](int i) { return row.getColumn(first + i).getInt64(); };
  const ProcessId process{text(1), text(2), text(3), integer(4), integer(5)};
  RunnerRow runner{process.host + ":" + std::to_string(process.pid), "", ""};
  if (!row.isColumnNull(first + 9)) {
    runner.gone = "its process has ended";
    return runner;
  }
  switch (liveness(process)) {
    case Liveness::alive:
      return runner;
    case Liveness::gone:
      runner.gone = "its process has gone";
      return runner;
    case Liveness::unknown:
      break;
  }
  runner.last_sign = text(6);
  if (heartbeats == nullptr) return runner;
  const double expires_s = row.getColumn(first + 8).getDouble();
  const double silent_s =
      heartbeats->silence(integer(0), text(6) + " " + text(7), expires_s / 4, Heartbeats::Clock::now());
  if (silent_s > expires_s) runner.gone = "its machine has been silent for too long";
  return runner;
}

}  // namespace mpmstudy
