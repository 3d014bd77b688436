#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/scene/report.hpp"

namespace mpm {

inline constexpr std::string_view all_bodies = "all";  ///< in place of the name of a body

/// The place of a gauge, which has as many coordinates.
template <int axes>
Vec<axes> gauge_vector(const std::vector<double>& place) {
  Vec<axes> x;
  for (int k = 0; k < axes; ++k) x[k] = place[static_cast<std::size_t>(k)];
  return x;
}

/// The gauges of a scene, read at every sample (area_every, and the end of the run).
///
/// point: between the particles around the place at time 0, whose shares are fixed then (multilinear: they
///   give back what grows evenly from particle to particle), as long as the run goes. They are all of the
///   body that the nearest one is of. Beyond the outermost particles: that of the nearest.
/// place: mean over the particles less than a cell away along every axis, weighed by mass and by
///   (1 - |dx| / h) (1 - |dy| / h); nothing where there is none.
/// beam: mean by mass over the particles less than a cell beside the beam and at most half a cell behind the
///   first of them that it meets, on its way from the place; nothing where it meets none.
/// body: sums over its particles, of what is modelled: half of a symmetric scene has half the mass, and the
///   centre of that half. Edges are those of the particles' domains.
/// wall: the momentum that it gave since the sample before, over the time since then; none at time 0.
/// contact: the same of what the field of the second body gave that of the first (contact/contacts.hpp), or
///   all that it gave so far.
///
/// Velocities are those that particles carry, which are half a time step older than their stresses
/// (step.hpp). Stress and pressure are without artificial viscosity, as in snapshots. What depends on mass is
/// per metre of depth in plane strain, per radian in axisymmetry, and whole in three dimensions; units say
/// so. Metrics: GAUGE.max, GAUGE.min, GAUGE.end, those of its reductions that the run was long enough for,
/// and GAUGE.stop, the time at which a threshold ended it. Checked by tests/libmpm/gauges_test.cpp.
template <int axes>
class BasicGauges : public BasicMeasurement<axes> {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  /// At time 0. The gauges have no problems (find_problems).
  BasicGauges(const Scene&, const State&);
  void after_step(const State&, const StepReport&, double dt) override;
  bool decided() const override;
  void sample(const State&, Observer&) override;
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

 private:
  /// What a gauge reads now; not finite: nothing. Empty: of the wall, or of a contact.
  using Read = std::function<double(const State&)>;
  double reading(std::size_t gauge, const State&) const;
  static Read reading_of(const Gauge&, const Scene&, const State&);
  double mean_force(double impulse, double time) const;  ///< since the last sample

  std::vector<Gauge> gauges_;
  std::vector<Read> reads_;
  std::vector<History> histories_;
  std::vector<double> stop_times_;  ///< when each gauge passed a threshold [s]; infinite: it has not
  /// What a gauge of a contact looks at, and what it saw.
  struct Contact {
    std::size_t gauge;
    int first, second;  ///< fields
    int axis;
    bool is_force;
    double given = 0;  ///< since the last sample, of an impulse since time 0 [kg/s]
  };
  std::vector<Contact> contacts_;
  double impulse_ = 0;      ///< that the wall has given since the last sample, along its normal
  double last_sample_ = 0;  ///< [s]
};

/// Particles [first, last) of the body of that name of a composed scene; "all": of all of them.
template <int axes>
typename BasicParticles<axes>::Range body_range(const Scene&, const BasicState<axes>&,
                                                const std::string& name);

/// When the last step of a history, from one sample to the next, went beyond a threshold [s]; infinite: it
/// did not.
double time_beyond(const History&, const Threshold&);

/// What a reduction comes to; empty where the history does not reach it.
std::optional<double> reduced(const History&, const Reduction&);

/// What is wrong with the gauges of a scene: of its own body, or of one that was made by hand. Names of
/// parameters are "gauge.NAME.KEY".
void check_gauges(const Scene&, Report&);
template <int axes>
void check_gauges(const Scene&, const BasicState<axes>& body, Report&);

}  // namespace mpm
