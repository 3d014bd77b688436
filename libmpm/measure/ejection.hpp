#pragma once
#include <vector>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// Whether the impact throws material out of the downstream wall (thickness d, of mass 2 R d rho0 per depth
/// above a cylinder, pi R^2 d rho0 above a sphere).
///
/// `ejected`: a connected part (connected.hpp, link length one cell) that has been apart from the body, the
/// heaviest part, for `detached_for`, has a hundredth of the wall's mass, is outside (its centre of mass is
/// above all of the body over its own extent across the impact), and rises faster than the free surface after
/// a planar shock does: 2 u against the moving body (doubling: within 3 % of the exact release up to 1500
/// m/s), u against the wall. `arrested`: nothing is ejected, and for `detached_for` the fastest twentieth of
/// the wall's mass near the axis (within R of it) has risen slower than that; counted from H/c0 + R/u on,
/// when shock and jet have arrived. Of a part that has come off, the mean speed counts: its particles can
/// only exchange momentum among themselves; fragments that are too small to be ejected do not count. Since
/// tension only slows what rises, such a wall does not come off later; `mpmstudy run
/// --audit` asks. `undecided`: neither by the end of the run. With Measures::stop = decided, the first
/// verdict ends it. Separation in MPM is numerical, by about a cell: verdicts depend on the cell.
///
/// Metrics: ejected_mass_kg_m, of a sphere ejected_mass_kg (of the whole, 0 if none), ejecta_speed_m_s (its
/// mean, against the wall), decision_time_s, decision_margin (distance of the deciding speed from u, in u:
/// positive if ejected). Checked by tests/libmpm/ejection_test.cpp.
template <int axes>
class BasicEjection : public BasicMeasurement<axes> {
 public:
  static std::span<const ResultRow> results();
  BasicEjection(const Scene&, const BasicState<axes>&);
  bool decided() const override { return stop_early_ && verdict_ != Verdict::undecided; }
  void sample(const BasicState<axes>&, Observer&) override;
  void finish(const BasicState<axes>&, RunResult&) const override;
  void carry(Archive&) override;

 private:
  enum class Verdict { undecided, ejected, arrested };

  struct Part;
  struct Parts;

  Parts parts_of(const BasicParticles<axes>&) const;
  void find_ejecta(const BasicState<axes>&, Parts&);
  void find_arrest(const BasicState<axes>&, const Parts&);
  void decide(Verdict, double time, double margin);
  double whole(const Part&, double modelled) const;

  double speed_;          ///< of the planar free surface against the wall [m/s]
  double radius_, link_;  ///< [m]
  double wall_mass_;      ///< [kg/m; of a sphere kg]
  double hold_;           ///< detached_for [s]
  double arrival_;        ///< of shock and jet at the wall [s]
  bool half_, axisymmetric_, is_sphere_, stop_early_;
  double all_;                       ///< what is modelled times this is all of it [1; in axisymmetry radians]
  std::vector<double> apart_since_;  ///< of each particle [s]; negative: part of the body
  double slow_since_ = -1;           ///< [s]; negative: the wall still rises fast
  Verdict verdict_ = Verdict::undecided;
  double decision_time_ = 0, margin_ = 0;
  double ejected_mass_ = 0, ejected_momentum_ = 0;  ///< at the last sample, of the whole
};
using Ejection = BasicEjection<2>;

}  // namespace mpm
