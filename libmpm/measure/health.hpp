#pragma once
#include <string>

#include "libmpm/measure/loads.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// The health of a run, looked at after every step.
///
/// A step is refused, and the run ends as failed, where
///   - a particle's state is not finite, or a particle left the grid;
///   - a body has reached an open side or floor of the grid;
///   - more than 1 % of the mass is beyond the equation of state: its pressure above pressure_limit, or
///     rho0/rho outside [1/4, 10). Where a cavity closes, pressure is singular, and what a jet leaves behind
///     is vapour: single particles pass or reach these limits, and are counted as overpressed_mass_fraction
///     and overstrained_mass_fraction;
///   - a particle is crushed to a twentieth of its volume, in scenes without an ideal gas;
///   - the step was longer than a cell over the fastest signal, CFL number 1: no explicit step is stable
///   there;
///   - the fastest signal is a hundred times that of the impact: nothing physical is, and the run would crawl
///     on in ever smaller steps;
///   - the kinetic energy is 1 % more than all the energy there was, with the work that was done on the
///   bodies: internal energy cannot be less than
///     nothing, so that motion grows by itself. This is how a step shows that is too long for the scheme;
///   - total energy is off by 1 %.
/// Metrics: smallest_density_ratio, largest_density_ratio (rho/rho0 of a particle, over the run),
/// overstrained_mass_fraction (largest share of the mass at one time), largest_cfl
/// (dt signal / h, with the signal at the end of the step).
template <int axes>
class BasicHealth : public BasicMeasurement<axes> {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  static std::span<const ResultRow> results();
  /// `speed`: of the fastest part of the body at the start [m/s].
  BasicHealth(const Scene&, const State&, double speed);
  void after_step(const State&, const StepReport&, double dt) override;
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

  enum class Trouble { none, not_finite, density, pressure, signal, time_step, growth, energy, open_face };
  /// What is wrong after the last step.
  Trouble trouble(double energy_error) const;
  /// Says so: the limit, the step, the time, the particle where it is worst with its place and state, and
  /// what may help. All particles must be up to date.
  std::string describe(Trouble, const State&, double energy_error) const;

 private:
  double initial_energy_, mass_, pressure_limit_, cell_, least_dilation_, largest_signal_;
  Loads loads_;
  StepReport last_;
  double last_cfl_ = 0, largest_cfl_ = 0;
  double smallest_dilation_ = 0, largest_dilation_ = 0, overstrained_mass_ = 0;
};
using Health = BasicHealth<2>;

}  // namespace mpm
