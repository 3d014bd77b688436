#pragma once
#include "libmpm/measure/contour.hpp"
#include "libmpm/measure/jet.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/void_area.hpp"

namespace mpm {

/// The cavity: its area by contour and by void, its form, and how much of it is left.
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
/// only for a contour that has not crossed itself; cavity_closed_time_s, cavity_joined_outside_time_s,
/// contour_crossed_time_s, each only if it happened; final_void_area_m2; new_cavities (the most closed
/// empty regions at one time beside the cavity itself), new_cavities_time_s (when the first of them was
/// seen), cavities_at_end; and those of Jet.
class Cavity : public Measurement {
 public:
  /// `open_below`: there is no wall, so that what reaches the lowest row of the grid is the outside.
  Cavity(const Scene&, const State&, bool open_below);
  void after_step(const State&, const StepReport&, double dt) override;
  RowRange rows_read(const Grid& grid) const override { return contour_.rows(grid); }
  void sample(const State&, Observer&) override;
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override;

 private:
  bool joined_outside() const;

  bool open_below_;
  Contour contour_;
  VoidArea void_;
  Jet jet_;
  std::vector<AreaSample> history_;
  double initial_offset_;           ///< centroid above the centre of mass [m]
  double smallest_area_;            ///< of the contour until it crosses itself [m^2]
  double smallest_difference_ = 0;  ///< between the two areas at the sample with the smallest one [m^2]
  double smallest_sample_;          ///< that one [m^2]
  int most_new_ = 0;                ///< closed empty regions beside the cavity, at one time
  double new_time_ = -1;            ///< when the first was seen [s]
  double closed_time_ = -1, joined_time_ = -1, crossed_time_ = -1;
  double topology_time_ = -1;   ///< the first of the three [s]
  double area_difference_ = 0;  ///< most between the two areas up to then [m^2]
};

}  // namespace mpm
