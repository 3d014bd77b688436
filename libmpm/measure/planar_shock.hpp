#pragma once
#include <vector>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// The planar shock, by gauges: particles of one column, evenly spaced in height, whose stress is recorded in
/// every step.
///
/// Plateau: mean over gauges from 0.15 H to 0.45 H at the time when the plastic front is at 0.6 H. Its noise:
/// rms deviation of the normal stress over its mean. Fronts (Lagrangian speeds): straight line through the
/// times at which gauges from 0.5 H to 0.8 H first pass half of the elastic limit, and the mean of the
/// elastic limit and the plateau. A wave that outruns the precursor (overdriven) leaves no elastic speed.
/// Elastic limit: normal stress where it rises least between the two fronts, over a tenth of the time between
/// them, mean of the gauges from 0.7 H to 0.8 H. The toe of the plastic front, some tens of cells long, must
/// have left a plateau by then: see tests/verification/.
/// Free-surface speed: against the moving body, mean over a quarter of the plastic wave's transit time, from
/// half a transit after its arrival at the top. Metrics: shock_normal_stress_Pa, shock_pressure_Pa,
/// shock_von_mises_Pa, plateau_noise, plastic_wave_speed_m_s, elastic_wave_speed_m_s,
/// elastic_limit_stress_Pa, free_surface_speed_m_s; each only if the run lasted long enough to show it.
template <int axes>
class BasicPlanarShock : public BasicMeasurement<axes> {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  static std::span<const ResultRow> results();
  BasicPlanarShock(const Scene&, const State&);
  void after_step(const State&, const StepReport&, double dt) override;
  std::span<const std::size_t> watched() const override { return watched_; }
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

 private:
  struct Reading {
    double normal_stress, pressure, von_mises;  ///< compression positive [Pa]
  };
  std::size_t first_gauge_above(double height) const;
  /// Time at which a gauge first passes the stress, by linear interpolation; negative if it never does.
  double arrival(std::size_t gauge, double stress) const;
  /// Speed of the front that passes `stress` [m/s]; 0 if it was not seen at 0.8 H.
  double front_speed(double stress) const;

  double stress_at(std::size_t gauge, double time) const;  ///< normal stress, interpolated [Pa]
  /// Normal stress where it rises least between the fronts that pass the two stresses [Pa]; 0 if they were
  /// not seen.
  double stress_between(double elastic_level, double plastic_level) const;

  double height_, impact_speed_, elastic_limit_, elastic_speed_;
  std::vector<std::size_t> gauges_;   ///< particles, upwards
  std::vector<double> gauge_height_;  ///< initial [m]
  std::size_t top_;                   ///< particle at the free surface
  std::vector<std::size_t> watched_;  ///< gauges and top
  std::vector<double> times_;
  std::vector<double> top_speed_;  ///< of the free surface against the moving body [m/s]
  std::vector<Reading> readings_;  ///< step by step, gauge by gauge
};
using PlanarShock = BasicPlanarShock<2>;

}  // namespace mpm
