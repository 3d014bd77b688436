#pragma once
#include <vector>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// The inner surface of an imploding shell, by markers that move with the material.
///
/// Radius: mean distance of the markers from the axis, of a sphere from its centre, each counted by its share
/// of the surface at the start. Stop: its minimum over the run; time by the parabola through the three steps
/// around it. The run ends once 1.3 times the stop time has passed, or at end_time. Metrics, if the shell
/// stopped before the end: stop_radius_m, stop_time_s, roundness ((largest - smallest) / mean distance at the
/// stop). Outcome: `arrested` if it stopped, else `undecided`.
template <int axes>
class BasicShell : public BasicMeasurement<axes> {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  static std::span<const ResultRow> results();
  BasicShell(const Scene&, const State&);
  void after_step(const State&, const StepReport&, double dt) override;
  RowRange rows_read(const BasicGrid<axes>&) const override;
  bool decided() const override;
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

 private:
  double share_of(std::size_t marker) const { return shares_.empty() ? 1 : shares_[marker]; }

  Vec<axes> center_;
  std::vector<Vec<axes>> markers_;
  std::vector<double> shares_;         ///< of the surface; empty: all the same
  std::vector<double> times_, radii_;  ///< step by step [s], [m]
  std::size_t stop_ = 0;               ///< step of the smallest radius so far
  double roundness_ = 0;               ///< at that step
};
using Shell = BasicShell<2>;

}  // namespace mpm
