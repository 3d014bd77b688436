#pragma once
/// A row of `runner`: who it is, and whether it still runs what it reserved.
#include <string>
#include <string_view>

#include "runner/catalog/heartbeats.hpp"

namespace SQLite {
class Statement;
}

namespace mpmstudy {

/// What runner_row() reads, of `runner r`.
inline constexpr std::string_view runner_columns =
    "r.id, r.host, r.boot_id, r.name_space, r.pid, r.process_start, r.heartbeat_at, r.beats, r.expires_s, "
    "r.ended_at";
/// The same of a catalog before version 7, which is read as it is.
inline constexpr std::string_view runner_columns_before_7 =
    "r.id, r.host, r.boot_id, '', r.pid, r.process_start, r.heartbeat_at, 0, 60.0, r.ended_at";

/// After this silence others may take a runner's jobs, where they cannot look for its process [s].
inline constexpr double default_heartbeat_expires_s = 60;

struct RunnerRow {
  std::string who;   ///< "host:pid"
  std::string gone;  ///< why nobody waits for it any longer; "" while it lives, or may
  /// Its last sign of life, UTC by its own clock, if this process cannot look for it; else "".
  std::string last_sign;
};

/// From the columns `first` and following. Without `heartbeats` (who looks once) a runner that cannot be
/// looked for is never gone.
RunnerRow runner_row(SQLite::Statement& row, int first, Heartbeats* heartbeats = nullptr);

}  // namespace mpmstudy
