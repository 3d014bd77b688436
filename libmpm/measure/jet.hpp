#pragma once
#include "libmpm/measure/results.hpp"
#include "libmpm/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// The jet that a strong shock sends through the cavity, on the axis: its tip is the marker that started at
/// the cavity's upstream pole, its target the one at the downstream pole.
///
/// Impact: when less than a cell is left between them (straight line between samples). Speed: the largest
/// between samples up to then, against the material ahead, which moves at -u: a free surface that a planar
/// shock leaves has 2 u. Lead: height of the tip above the shock at the sides of the block, the largest
/// before the impact and before that shock has left the block, counted once the shock has passed the tip;
/// negative: the tip never overtook it. The shock: the highest particle of the outermost two columns of cells
/// (of three axes, and slices) that has lost half of its speed. Metrics: jet_speed_m_s, jet_lead_m;
/// jet_impact_time_s, jet_overtake_time_s if they happened.
template <int axes>
class BasicJet {
 public:
  static std::span<const ResultRow> results();
  explicit BasicJet(const Scene&);
  /// tip, target: heights of the two poles [m].
  void sample(const BasicState<axes>&, double tip, double target);
  void finish(RunResult&) const;
  void carry(Archive&);

 private:
  double shock_height(
      const BasicState<axes>&) const;  ///< at the sides [m]; infinite once it has left the block

  double impact_speed_, side_, cell_;
  double time_ = -1, tip_ = 0, gap_ = 0, lead_ = 0;  ///< at the last sample
  double speed_ = 0, most_lead_ = 0;
  double impact_time_ = -1, overtake_time_ = -1;
  bool passed_ = false;  ///< the shock at the sides has passed the tip
  bool led_ = false;     ///< a lead was measured
};
using Jet = BasicJet<2>;

}  // namespace mpm
