#pragma once
/// What a user of the library calls: run a scene, or take it step by step, with parts of one's own.
#include <memory>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/observer.hpp"
#include "libmpm/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm {

/// One run.
///
///   Simulation s(scene);                       // or Simulation(scene, body), with a body of one's own
///   s.add(std::make_unique<MyGauge>(...));     // beside what the scene is measured by; may be left out
///   RunResult r = s.run();                     // or: while (s.step()) look_at(s.state());  r = s.result();
///
/// Scenes of three axes (space = three-d) are run by a Simulation3, which has a state of three axes.
/// Belongs to one thread at a time. A breakdown is a result, not an exception.
template <int axes>
class BasicSimulation {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;
  using Stepper = BasicStepper<axes>;
  using Measurement = BasicMeasurement<axes>;

  /// The scene's own body and measurements. Throws InputError naming all that find_problems() finds, or the
  /// space where it has not these axes.
  explicit BasicSimulation(const Scene&);
  /// A body of one's own (body/fill.hpp makes them), and no measurements but the balance and the health of
  /// the run, and the scene's gauges. Of the scene it takes material, numerics, measures and end time. Throws
  /// InputError naming what is wrong with these, or with the body. Columns of the body that are empty though
  /// the scene has them (velocity gradient, back stress) begin at zero.
  BasicSimulation(const Scene&, State body);
  ~BasicSimulation();
  BasicSimulation(BasicSimulation&&) noexcept;
  BasicSimulation& operator=(BasicSimulation&&) noexcept;

  /// Takes the steps in place of the scene's own stepper; it must set the report's signal, from which time
  /// steps follow, and its dilations, kinetic energy and masses beyond limits, which the health of the run is
  /// judged by. Throws std::logic_error once a step was taken.
  void use(std::unique_ptr<Stepper>);
  /// Measures beside the others, after them. Throws std::logic_error once a step was taken.
  void add(std::unique_ptr<Measurement>);

  /// Runs to the end, or until the observer stops it: then the result has what was measured up to there.
  RunResult run(Observer&);
  RunResult run();
  /// One step of that: a time step for which the next sample or snapshot is hit exactly, the measurements,
  /// and what the observer is to be told. False if the run is over: no step was taken, or none is to follow.
  bool step(Observer&);
  bool step();
  /// A step of this length [s], of which no sample is taken and whose health nobody judges; the report says
  /// what happened. Samples and snapshots that were due on the way are left out of the rest of the run.
  StepReport step(double dt);
  /// The time step that the CFL number allows after the last step [s].
  double time_step() const;

  /// Particles and nodes, brought up to date; the velocity gradient by the reference step alone.
  const State& state();
  double time() const;  ///< [s]
  Stepper& stepper();   ///< to give it threads, and to ask what it took
  /// What was measured so far.
  RunResult result();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

using Simulation = BasicSimulation<2>;
using Simulation3 = BasicSimulation<3>;

/// Simulation(scene).run(), in whatever space.
RunResult run(const Scene&, Observer&);
RunResult run(const Scene&);

}  // namespace mpm
