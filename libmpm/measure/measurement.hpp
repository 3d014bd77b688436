#pragma once
#include "libmpm/simulation.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// One observable. Sees the state; changes nothing. Calls come in this order:
///   after_step (every step), decided, sample (every area_every and at the end), finish (once).
class Measurement {
 public:
  virtual ~Measurement() = default;
  /// `state.grid` still holds the nodal motion of the step.
  virtual void after_step(const State&, const StepReport&, double /*dt*/) {}
  /// True once nothing that is still to come can change what is measured: the run ends here.
  virtual bool decided() const { return false; }
  virtual void sample(const State&) {}
  virtual void finish(const State&, RunResult&) = 0;
};

}  // namespace mpm
