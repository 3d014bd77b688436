#pragma once
#include <type_traits>

#include "libmpm/measure/loads.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// Kinetic and internal energy of the particles [J/m], of three axes [J].
struct Energy {
  double kinetic = 0, internal = 0;
  double total() const { return kinetic + internal; }
};
template <int axes>
Energy energy_of(const BasicParticles<axes>&);
/// Of some of them.
template <int axes>
Energy energy_of(const BasicParticles<axes>&,
                 const std::type_identity_t<typename BasicParticles<axes>::Range>&);

/// Momentum of the particles [kg/s], of three axes [kg m/s].
template <int axes>
Vec<axes> momentum_of(const BasicParticles<axes>&);

/// Balance of energy and momentum. Walls at rest do no work, so kinetic + internal energy is constant;
/// momentum changes by the walls' impulse. Gravity and rigid bodies that move do work, and give momentum: it
/// is counted step by step (step/gravity.hpp, contact/resolve.hpp). Errors are relative to what the body had
/// at the start (momentum: the sum of m |v|, since that of m v may vanish) and the size of what came in
/// since, and the largest of the run. Metrics: energy_error, momentum_error, transfer_heat_fraction (kinetic
/// energy that the transfer turned into heat, over the initial energy), final_kinetic_fraction,
/// overpressed_mass_fraction (largest share of the mass that was beyond the range of the equation of state at
/// one time).
template <int axes>
class BasicBalance : public BasicMeasurement<axes> {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  static std::span<const ResultRow> results();
  explicit BasicBalance(const State&);
  void after_step(const State&, const StepReport&, double dt) override;
  void sample(const State&, Observer&) override;
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

  /// Kinetic and internal energy at the start, and all work that was done since, whatever its sign [J/m].
  double energy_scale() const { return initial_energy_ + loads_.gross_work; }
  double energy_error() const { return energy_error_; }

 private:
  void look_at(const State&);

  double initial_energy_;
  Vec<axes> initial_momentum_;
  double momentum_scale_;
  Loads loads_;
  Vec<axes> impulse_ = Vec<axes>::Zero();
  double transfer_heat_ = 0;
  double energy_error_ = 0, momentum_error_ = 0;
  double overpressed_mass_ = 0;
};
using Balance = BasicBalance<2>;

}  // namespace mpm
