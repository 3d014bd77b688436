#pragma once
/// A row of `runner`: who it is, and whether it still runs what it claimed.
#include <string>
#include <string_view>

namespace SQLite {
class Statement;
}

namespace mpmstudy {

/// What runner_row() reads, of `runner r`.
inline constexpr std::string_view runner_columns =
    "r.host, r.boot_id, r.pid, r.process_start, r.heartbeat_at, r.ended_at";

/// A runner of another host that is silent for longer is gone [s].
inline constexpr double default_heartbeat_expires_s = 60;

struct RunnerRow {
  std::string who;   ///< "host:pid"
  std::string gone;  ///< why nobody waits for it any longer; "" while it lives
};

/// From the columns `first` and following. now: UTC.
RunnerRow runner_row(SQLite::Statement& row, int first, const std::string& now,
                     double heartbeat_expires_s = default_heartbeat_expires_s);

}  // namespace mpmstudy
