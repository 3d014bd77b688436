#pragma once
/// What a user of the library calls: run a scene, watch it, read what it measured.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/core/archive.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Raised whenever the bits of any result may change; part of every job's key.
inline constexpr int physics_version = 5;

struct Progress {
  std::int64_t step = 0;
  double time = 0;       ///< [s]
  double end_time = 0;   ///< [s]
  double time_step = 0;  ///< [s]
  std::int64_t particles = 0;
};

struct AreaSample {
  double time = 0;       ///< [s]
  double area = 0;       ///< by the contour of markers [m^2]
  double void_area = 0;  ///< by the empty region of the indicator field [m^2]
};

/// Fields of all particles at one time. Columns have the same length. Vectors are (x, y).
/// Half of a symmetric scene is handed over as it was modelled: x >= 0.
struct Snapshot {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::vector<double> x, y;                    ///< [m]
  std::vector<double> velocity_x, velocity_y;  ///< [m/s]
  std::vector<double> mass;                    ///< per depth [kg/m]
  std::vector<double> density;                 ///< [kg/m^3]
  std::vector<double> pressure;                ///< compression positive, without artificial viscosity [Pa]
  std::vector<double> stress_xx, stress_yy, stress_xy, stress_zz;  ///< Cauchy, tension positive [Pa]
  std::vector<double> von_mises;                                   ///< [Pa]
  std::vector<double> equivalent_plastic_strain;                   ///< [1]
  std::vector<double> plastic_work;                                ///< per current volume [J/m^3]
  std::vector<double> specific_internal_energy;  ///< half a step behind the stress, as it is carried [J/kg]
  std::vector<double> temperature;               ///< [K]
};

/// Watches a run, on the thread that runs it. Every member may be left as it is.
class Observer {
 public:
  virtual ~Observer() = default;
  /// After every step. Return false to stop the run.
  virtual bool on_step(const Progress&) { return true; }
  /// How many threads the next step may use, with the one that runs it. Results do not depend on it.
  virtual int threads() { return 1; }
  virtual void on_area(const AreaSample&) {}
  virtual void on_snapshot(const Snapshot&) {}

  /// Of long runs. What an earlier run of the same scene gave to on_checkpoint: this one goes on from there,
  /// gives the snapshots and areas that follow, and ends with the same bits as a run that was never
  /// disturbed. Asked once, at the start.
  virtual Record* resume_from() { return nullptr; }
  /// After every step, before on_step: is a checkpoint wanted now? It costs about as much as a snapshot.
  virtual bool wants_checkpoint() { return false; }
  virtual void on_checkpoint(const Record&) {}
};

struct Metric {
  std::string name;
  double value = 0;
  std::string unit;             ///< SI; "1" for a pure number
  std::optional<double> error;  ///< half width of its interval, same unit; empty where none is known
};

enum class RunStatus {
  done,     ///< reached its end
  stopped,  ///< the observer said so
  failed,   ///< broke down, or left a health limit; `reason` says where
};

/// What a run leaves behind. Numbers that a scene does not have are empty.
struct RunResult {
  RunStatus status = RunStatus::done;
  std::string reason;
  std::int64_t particles = 0;
  std::int64_t steps = 0;
  double helper_seconds = 0;  ///< processor time of the threads beside the one that called [s]
  double energy_error =
      0;  ///< |E - E0| / E0, largest over the samples; E: kinetic + internal (walls at rest do no work)
  std::string
      outcome;  ///< collapsed, partial, ejected, arrested, undecided; empty where the scene decides nothing
  std::optional<double> initial_area, final_area, final_area_error;  ///< [m^2]
  std::optional<double> collapsibility, collapsibility_error;        ///< (A0 - A)/A0 [1]
  std::vector<AreaSample> area_history;
  std::vector<Metric> metrics;
};

/// Runs the scene to its end. Throws InputError if find_problems() finds any, or if what it is to go on from
/// does not fit; a breakdown is a result.
RunResult run(const Scene&, Observer&);
RunResult run(const Scene&);

}  // namespace mpm
