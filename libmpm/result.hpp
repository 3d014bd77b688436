#pragma once
/// What a run leaves behind: plain data.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/observer.hpp"

namespace mpm {

/// Raised whenever the bits of any result may change; part of every job's key.
inline constexpr int physics_version = 5;

struct Metric {
  std::string name;
  double value = 0;
  std::string unit;             ///< SI; "1" for a pure number
  std::optional<double> error;  ///< half width of its interval, same unit; empty where none is known
};

/// What a gauge of the scene saw (scene/gauge.hpp). Times at which there was nothing to see are left out.
struct History {
  std::string name;           ///< of the gauge
  std::string unit;           ///< of `values`: SI; "1" for a pure number
  std::vector<double> times;  ///< [s], ascending
  std::vector<double> values;
};

enum class RunStatus {
  done,     ///< reached its end
  stopped,  ///< the observer said so, or the end is not reached yet
  failed,   ///< broke down, or left a health limit; `reason` says where
};

/// Numbers that a scene does not have are empty.
struct RunResult {
  RunStatus status = RunStatus::done;
  std::string reason;
  std::int64_t particles = 0;
  std::int64_t steps = 0;
  double helper_seconds = 0;  ///< processor time of the threads beside the one that called [s]
  /// |E - E0| / E0, largest over the samples; E: kinetic + internal (walls at rest do no work)
  double energy_error = 0;
  /// collapsed, partial, ejected, arrested, undecided; empty where the scene decides nothing
  std::string outcome;
  std::optional<double> initial_area, final_area, final_area_error;  ///< [m^2]
  std::optional<double> collapsibility, collapsibility_error;        ///< (A0 - A)/A0 [1]
  std::vector<AreaSample> area_history;
  std::vector<History> histories;  ///< one for each gauge, in their order
  std::vector<Metric> metrics;

  /// The metric of that name; null if the run has none.
  const Metric* find(std::string_view name) const {
    for (const Metric& m : metrics)
      if (m.name == name) return &m;
    return nullptr;
  }
  /// The history of the gauge of that name; null if the scene has none.
  const History* history(std::string_view gauge) const {
    for (const History& h : histories)
      if (h.name == gauge) return &h;
    return nullptr;
  }
};

}  // namespace mpm
