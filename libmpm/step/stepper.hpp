#pragma once
#include <cstddef>
#include <span>

#include "libmpm/core/archive.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// Where the steps of a stepper have spent their time so far [s]. The fast step does grid to particles,
/// stress and particles to grid in one pass, so that they have one number.
struct StepTimes {
  double sort = 0, grid = 0, particles = 0;
};

/// Advances a State. A stepper may keep the particles and the nodes in a form of its own; then what the State
/// holds is as old as the last refresh.
template <int axes>
class BasicStepper {
 public:
  using State = BasicState<axes>;

  virtual ~BasicStepper() = default;
  virtual BasicStepReport<axes> step(State&, double dt) = 0;

  /// Brings all of state.particles up to date, in the order in which they were built.
  virtual void refresh_particles(State&) {}
  /// Brings some of them up to date. Cheap when it is the same few again and again.
  virtual void refresh_particles(State&, std::span<const std::size_t> /*which*/) {}
  /// Brings mass and velocity of the nodes of rows [first, last] up to date: the motion of the last step.
  /// Rows that the grid does not have are left out.
  virtual void refresh_nodes(State&, int /*first_row*/, int /*last_row*/) {}
  /// All that the next step depends on, apart from time and number of the step. The State is the one that the
  /// run began with.
  virtual void carry(State& state, Archive& archive) {
    carry_particles(state.particles, archive);
    carry_wall_gaps(state, archive);
  }
  /// How many threads the next steps may use, with the one that calls; the results are the same bits. A
  /// stepper may use fewer.
  virtual void use_threads(int) {}
  /// Processor time of the threads beside the caller's, so far [s].
  virtual double helper_seconds() const { return 0; }
  /// Zero for a stepper that does not look at the clock.
  virtual StepTimes times() const { return {}; }
  /// Memory that the stepper keeps beside the State [bytes].
  virtual std::size_t memory() const { return 0; }

 protected:
  static void carry_wall_gaps(State& state, Archive& archive) {
    if (state.tracks_wall_gap) archive.numbers("wall_gaps", state.wall_gaps);
  }
};
using Stepper = BasicStepper<2>;

}  // namespace mpm
