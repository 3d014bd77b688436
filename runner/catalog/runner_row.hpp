#pragma once
/// A row of `runner`: who it is, and whether its process has gone.
#include <string>
#include <string_view>

namespace SQLite {
class Statement;
}

namespace mpmstudy {

/// What RunnerRow reads, of `runner r`.
inline constexpr std::string_view runner_columns =
    "r.host, r.boot_id, r.pid, r.process_start, r.heartbeat_at, r.ended_at";

/// A runner of another host that is silent for longer is gone [s].
inline constexpr double default_heartbeat_expires_s = 60;

struct RunnerRow {
  std::string who;  ///< "host:pid"
  bool gone = false;
};

/// From the columns `first` and following. now: UTC.
RunnerRow runner_row(SQLite::Statement& row, int first, const std::string& now,
                     double heartbeat_expires_s = default_heartbeat_expires_s);

}  // namespace mpmstudy
