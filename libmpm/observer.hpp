#pragma once
/// What a run tells whoever watches it.
#include <cstdint>
#include <vector>

#include "libmpm/core/archive.hpp"

namespace mpm {

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

/// Fields of all particles at one time. Columns have the same length; those along z are there in scenes of
/// three axes only. Half of a symmetric scene is handed over as it was modelled: x >= 0.
struct Snapshot {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::vector<double> x, y, z;                             ///< [m]
  std::vector<double> velocity_x, velocity_y, velocity_z;  ///< [m/s]
  std::vector<double> mass;      ///< density times area in the plane: per depth, in axisymmetry per
                                 ///< length of the hoop [kg/m]; of three axes whole [kg]
  std::vector<double> density;   ///< [kg/m^3]
  std::vector<double> pressure;  ///< compression positive, without artificial viscosity [Pa]
  std::vector<double> stress_xx, stress_yy, stress_xy, stress_zz;  ///< Cauchy, tension positive [Pa]
  std::vector<double> stress_xz, stress_yz;                        ///< [Pa]
  std::vector<double> von_mises;                                   ///< [Pa]
  std::vector<double> equivalent_plastic_strain;                   ///< [1]
  std::vector<double> plastic_work;                                ///< per current volume [J/m^3]
  std::vector<double> specific_internal_energy;  ///< half a step behind the stress, as it is carried [J/kg]
  std::vector<double> temperature;               ///< [K]

  bool has_depth() const { return !z.empty(); }
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

}  // namespace mpm
