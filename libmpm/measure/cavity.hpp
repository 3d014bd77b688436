#pragma once
#include <type_traits>
#include <vector>

#include "libmpm/measure/contour.hpp"
#include "libmpm/measure/jet.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"
#include "libmpm/measure/surface.hpp"
#include "libmpm/measure/void_area.hpp"

namespace mpm {

/// The cavity: its area by contour and by void, its form, and how much of it is left. In axisymmetry areas
/// are those of the section through the axis, both halves, of three axes those of the section z = 0, as is
/// what is said of its form; what is said of collapse is said of volumes.
///
/// Final area: mean of the contour's area over the last quarter of the run; of the void's, once the contour
/// has crossed itself. Its error: the scatter over that window (standard deviation) and the mean difference
/// between the two areas, in quadrature; the two are the metrics final_area_scatter_m2 and
/// final_area_difference_m2. largest_collapsibility: (initial - smallest area) / initial, of the contour
/// until it first crosses itself, looked at after every step; its error: what the two areas differed by at
/// the sample next to it. It has a limit where the final area has none, because a cavity that closed was torn
/// open again. Outcome: `collapsed` if the void is gone at the end, else `partial`. A void that opens again
/// elsewhere after it was gone is not followed.
///
/// Contour and void measure one thing while the cavity is one hole in the block: until it closes, joins the
/// outside or its contour crosses itself (topology_changed_time_s, the first of the three) they differ by
/// less than a tenth of a strip one cell wide along the initial circle. area_difference_m2 is the most that
/// they did up to then. Metrics: those; aspect_ratio (width / height),
/// lower_upper_area_ratio, centroid_shift_m (along the impact, against the body's centre of mass), all three
/// only for a contour that has not crossed itself; initial_volume_m3, final_volume_m3 and the like where
/// there are volumes; cavity_closed_time_s, cavity_joined_outside_time_s, contour_crossed_time_s, each only
/// if it happened; final_void_area_m2; new_cavities (the most closed empty regions at one time beside the
/// cavity itself), new_cavities_time_s (when the first of them was seen), cavities_at_end; and those of Jet.
template <int axes>
class BasicCavity : public BasicMeasurement<axes> {
 public:
  using State = BasicState<axes>;
  using StepReport = BasicStepReport<axes>;

  static std::span<const ResultRow> results();
  /// `open_below`: there is no wall, so that what reaches the lowest row of the grid is the outside.
  BasicCavity(const Scene&, const State&, bool open_below);
  void after_step(const State&, const StepReport&, double dt) override;
  RowRange rows_read(const BasicGrid<axes>& grid) const override { return outline_.rows(grid); }
  void sample(const State&, Observer&) override;
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

 private:
  /// By contour and by void: an area [m^2], or where there are volumes one of them [m^3].
  struct Size {
    double contour, empty;
  };
  struct Ending;
  double contour_size() const { return by_volume_ ? outline_.volume() : section().area(); }
  decltype(auto) section() const {
    if constexpr (axes == 2)
      return (outline_);
    else
      return outline_.section();
  }
  Ending ending(double start, const std::vector<Size>&) const;
  bool joined_outside() const;

  bool open_below_, by_volume_;
  std::conditional_t<axes == 2, Contour, Surface> outline_;
  BasicVoidArea<axes> void_;
  BasicJet<axes> jet_;
  std::vector<AreaSample> history_;
  std::vector<Size> sizes_;         ///< at the samples of history_
  double initial_offset_;           ///< centroid above the centre of mass [m]
  double smallest_size_;            ///< of the contour until it crosses itself
  double smallest_difference_ = 0;  ///< between contour and void at the sample with the smallest one
  double smallest_sample_;          ///< that one
  int most_new_ = 0;                ///< closed empty regions beside the cavity, at one time
  double new_time_ = -1;            ///< when the first was seen [s]
  double closed_time_ = -1, joined_time_ = -1, crossed_time_ = -1;
  double topology_time_ = -1;   ///< the first of the three [s]
  double area_difference_ = 0;  ///< most between the two areas up to then [m^2]
};
using Cavity = BasicCavity<2>;

}  // namespace mpm
