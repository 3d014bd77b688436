#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "libmpm/core/archive.hpp"
#include "libmpm/observer.hpp"
#include "libmpm/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// One observable of a run with so many axes. Sees the state; changes nothing. Calls come in this order:
///   after_step (every step), decided, sample (every area_every and at the end).
/// finish may be asked at any time.
template <int axes>
class BasicMeasurement {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  virtual ~BasicMeasurement() = default;
  /// Of the state, only the time, the watched particles and the rows that are read are up to date; state.grid
  /// holds the nodal motion of the step.
  virtual void after_step(const State&, const StepReport&, double /*dt*/) {}
  /// Particles that after_step reads.
  virtual std::span<const std::size_t> watched() const { return {}; }
  /// Rows of nodes that after_step reads.
  virtual RowRange rows_read(const BasicGrid<axes>&) const { return {}; }
  /// True once nothing that is still to come can change what is measured: the run ends here.
  virtual bool decided() const { return false; }
  /// Of the state, all particles are up to date. What is worth watching goes to the observer.
  virtual void sample(const State&, Observer&) {}
  /// Adds what was measured so far. All particles are up to date.
  virtual void finish(const State&, RunResult&) const = 0;
  /// Everything that it keeps from one call to the next; what its constructor makes is there already.
  virtual void carry(Archive&) = 0;
};
using Measurement = BasicMeasurement<2>;

template <int axes>
using BasicMeasurements = std::vector<std::unique_ptr<BasicMeasurement<axes>>>;

}  // namespace mpm
