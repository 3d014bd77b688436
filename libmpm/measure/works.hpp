#pragma once
#include "libmpm/measure/loads.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// What was done to the bodies of a composed scene on the way, over its energy: that of the start and the
/// size of all work that was done since. Metrics: gravity_work_fraction, of scenes that have gravity;
/// contact_heat_fraction, friction_heat_fraction and rigid_work_fraction, of scenes with contact.
template <int axes>
class BasicWorks : public BasicMeasurement<axes> {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  static std::span<const ResultRow> results();
  /// Whether a scene has any of it.
  static bool measures(const Scene&);
  BasicWorks(const Scene&, const State&);
  void after_step(const State&, const StepReport&, double dt) override;
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

 private:
  bool has_gravity_, has_contact_;
  double initial_energy_;
  Loads loads_;
  double gravity_work_ = 0, contact_heat_ = 0, friction_heat_ = 0, rigid_work_ = 0;
};
using Works = BasicWorks<2>;

}  // namespace mpm
