#include "libmpm/measure/cavity.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "collapsibility",
     .unit = "1",
     .symbol = "Φ",
     .meaning = "(initial - final) / initial area of the cavity; a torn cavity may be larger than it was",
     .upper = 1,
     .least_scale = 0.1,
     .metric = false,
     .column = true,
     .error_column = "collapsibility_error",
     .lost_share_of = {"final_volume_m3", "final_area_m2"},  // in axisymmetry it is made of volumes
     .of_closed_cavity = true},
    {.name = "final_area_m2",
     .unit = "m2",
     .symbol = "A",
     .title = "Final cavity area",
     .meaning = "area of the cavity at the end",
     .lower = 0,
     .metric = false,
     .column = true,
     .error_column = "final_area_error_m2",
     .difference = "final_area_difference_m2",
     .scatter = "final_area_scatter_m2",
     .of_closed_cavity = true},
    {.name = "initial_area_m2",
     .unit = "m2",
     .symbol = "A",
     .title = "Initial cavity area",
     .meaning = "area of the cavity at the start",
     .has_interval = false,
     .lower = 0,
     .metric = false,
     .column = true},
    {.name = "aspect_ratio",
     .unit = "1",
     .title = "Width over height of the cavity",
     .meaning = "width / height of the cavity at the end",
     .always = false},
    {.name = "lower_upper_area_ratio",
     .unit = "1",
     .title = "Cavity area below over above its centre",
     .meaning = "area of the cavity at the end below / above the chord between the markers that started at "
                "its centre's height",
     .always = false},
    {.name = "centroid_shift_m",
     .unit = "m",
     .meaning = "way of the cavity's centroid along y against the body's centre of mass",
     .always = false},
    {.name = "final_void_area_m2",
     .unit = "m2",
     .symbol = "A",
     .meaning = "area of the empty region at the end, by the indicator field",
     .lower = 0,
     .of_closed_cavity = true},
    {.name = "final_area_scatter_m2",
     .unit = "m2",
     .meaning =
         "part of the final area's measuring error: standard deviation over the last quarter of the run",
     .has_interval = false,
     .lower = 0},
    {.name = "final_area_difference_m2",
     .unit = "m2",
     .meaning = "the other part: mean difference between contour and empty region there",
     .has_interval = false,
     .lower = 0},
    {.name = "initial_volume_m3",
     .unit = "m3",
     .symbol = "V",
     .title = "Initial cavity volume",
     .meaning = "volume of the cavity at the start",
     .has_interval = false,
     .lower = 0,
     .spaces = {Space::axisymmetric, Space::three_d}},
    {.name = "final_volume_m3",
     .unit = "m3",
     .symbol = "V",
     .title = "Final cavity volume",
     .meaning = "volume of the cavity at the end, of which collapsibility is made",
     .lower = 0,
     .spaces = {Space::axisymmetric, Space::three_d},
     .difference = "final_volume_difference_m3",
     .scatter = "final_volume_scatter_m3",
     .of_closed_cavity = true},
    {.name = "final_volume_scatter_m3",
     .unit = "m3",
     .meaning = "part of the final volume's measuring error, as of the area",
     .has_interval = false,
     .lower = 0,
     .spaces = {Space::axisymmetric, Space::three_d}},
    {.name = "final_volume_difference_m3",
     .unit = "m3",
     .meaning = "the other part, as of the area",
     .has_interval = false,
     .lower = 0,
     .spaces = {Space::axisymmetric, Space::three_d}},
    {.name = "largest_collapsibility",
     .unit = "1",
     .meaning =
         "(initial - smallest area) / initial area, by the contour until it first crosses itself. Cells "
         "converge to it also where a closed cavity is torn open again and the final area has no limit",
     .upper = 1,
     .least_scale = 0.1},
    {.name = "cavity_closed_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "when the empty region was first gone",
     .always = false},
    {.name = "cavity_joined_outside_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "when the empty region first met the outside",
     .always = false},
    {.name = "contour_crossed_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "when the contour of markers first crossed itself; its area means less from then on",
     .always = false},
    {.name = "topology_changed_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "the first of these three: the cavity was one closed hole up to then",
     .always = false},
    {.name = "area_difference_m2",
     .unit = "m2",
     .meaning = "most that contour and empty region differed by up to then; less than a tenth of a cell "
                "times the initial circumference",
     .has_interval = false,
     .lower = 0},
    {.name = "new_cavities",
     .unit = "1",
     .meaning = "most closed empty regions at one time beside the cavity"},
    {.name = "new_cavities_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "when the first of them was seen",
     .always = false},
    {.name = "cavities_at_end", .unit = "1", .meaning = "closed empty regions at the end"},
};

template <int axes>
double center_of_mass_height(const BasicParticles<axes>& ps) {
  double mass = 0, moment = 0;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    mass += ps.mass[p];
    moment += ps.mass[p] * ps.position[p].y();
  }
  return moment / mass;
}

/// The point of the axis at this height.
template <int axes>
Vec<axes> on_axis(double y) {
  Vec<axes> x = Vec<axes>::Zero();
  x.y() = y;
  return x;
}

constexpr double window = 0.25;  ///< share of the run that counts as its end

}  // namespace

template <int axes>
std::span<const ResultRow> BasicCavity<axes>::results() {
  return rows;
}

template <int axes>
BasicCavity<axes>::BasicCavity(const Scene& s, const State& state, bool open_below)
    : open_below_(open_below),
      by_volume_(state.space != Space::plane_strain),
      outline_(on_axis<axes>(s.cavity_center_height), s.cavity_radius, s.numerics.cell_size,
               s.numerics.symmetry == Symmetry::half),
      void_(on_axis<axes>(s.cavity_center_height), s.cavity_radius, s.numerics.symmetry == Symmetry::full,
            s.numerics.particles_per_cell),
      jet_(s),
      initial_offset_(section().centroid().y() - center_of_mass_height(state.particles)),
      smallest_size_(contour_size()),
      smallest_sample_(smallest_size_) {}

template <int axes>
void BasicCavity<axes>::after_step(const State& s, const StepReport&, double dt) {
  outline_.advance(s.grid, dt);
  if (crossed_time_ < 0) smallest_size_ = std::min(smallest_size_, std::max(contour_size(), 0.0));
}

template <int axes>
bool BasicCavity<axes>::joined_outside() const {
  return void_.joined_outside() || (open_below_ && void_.touches_wall());
}

template <int axes>
void BasicCavity<axes>::sample(const State& s, Observer& observer) {
  const AreaSample now{s.time, section().area(), void_.update(s)};
  if (now.void_area == 0 && closed_time_ < 0) closed_time_ = s.time;
  if (joined_outside() && joined_time_ < 0) joined_time_ = s.time;
  if (crossed_time_ < 0 && outline_.crosses_itself()) crossed_time_ = s.time;
  if (topology_time_ < 0 && std::max({closed_time_, joined_time_, crossed_time_}) >= 0)
    topology_time_ = s.time;
  if (topology_time_ < 0) area_difference_ = std::max(area_difference_, std::abs(now.void_area - now.area));
  const bool itself = now.void_area > 0 && !void_.joined_outside() && !void_.touches_wall();
  const int others = void_.closed_regions() - (itself ? 1 : 0);
  most_new_ = std::max(most_new_, others);
  if (others > 0 && new_time_ < 0) new_time_ = s.time;
  jet_.sample(s, outline_.upstream_pole().y(), outline_.downstream_pole().y());
  const Size size = by_volume_ ? Size{contour_size(), void_.volume()} : Size{now.area, now.void_area};
  if (crossed_time_ < 0 && size.contour < smallest_sample_) {
    smallest_sample_ = size.contour;
    smallest_difference_ = std::abs(size.empty - size.contour);
  }
  history_.push_back(now);
  sizes_.push_back(size);
  observer.on_area(now);
}

/// What is left of a history: its mean from a time on, the scatter, and by how much the void is larger.
template <int axes>
struct BasicCavity<axes>::Ending {
  double mean, scatter, difference;
  double error() const { return std::hypot(scatter, difference); }
};

template <int axes>
typename BasicCavity<axes>::Ending BasicCavity<axes>::ending(double start,
                                                             const std::vector<Size>& sizes) const {
  const auto size_at = [&](std::size_t k) {
    return crossed_time_ >= 0 && history_[k].time >= crossed_time_ ? sizes[k].empty : sizes[k].contour;
  };
  double count = 0, sum = 0, sum_of_squares = 0, difference = 0;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (history_[k].time < start) continue;
    ++count;
    sum += size_at(k);
    difference += sizes[k].empty - sizes[k].contour;
  }
  const double mean = sum / count;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    if (history_[k].time >= start) sum_of_squares += (size_at(k) - mean) * (size_at(k) - mean);
  return {mean, std::sqrt(sum_of_squares / count), difference / count};
}

template <int axes>
void BasicCavity<axes>::finish(const State& s, RunResult& result) const {
  // the last sample, if a run that was stopped has none in the window
  const double start = std::min((1 - window) * s.time, history_.back().time);
  std::vector<Size> areas;
  for (const AreaSample& a : history_) areas.push_back({a.area, a.void_area});
  const Ending area = ending(start, areas), size = by_volume_ ? ending(start, sizes_) : area;
  const double initial = sizes_.front().contour;

  result.initial_area = history_.front().area;
  result.final_area = area.mean;
  result.final_area_error = area.error();
  result.collapsibility = (initial - size.mean) / initial;
  result.collapsibility_error = size.error() / initial;
  result.outcome = history_.back().void_area == 0 ? "collapsed" : "partial";

  auto& m = result.metrics;
  m.push_back(metric(row_of(rows, "final_area_scatter_m2"), area.scatter));
  m.push_back(metric(row_of(rows, "final_area_difference_m2"), std::abs(area.difference)));
  if (by_volume_) {
    m.push_back(metric(row_of(rows, "initial_volume_m3"), initial));
    m.push_back(metric(row_of(rows, "final_volume_m3"), size.mean, size.error()));
    m.push_back(metric(row_of(rows, "final_volume_scatter_m3"), size.scatter));
    m.push_back(metric(row_of(rows, "final_volume_difference_m3"), std::abs(size.difference)));
  }
  m.push_back(metric(row_of(rows, "largest_collapsibility"), (initial - smallest_size_) / initial,
                     smallest_difference_ / initial));
  if (crossed_time_ < 0) {
    const Contour& form = section();
    m.push_back(metric(row_of(rows, "aspect_ratio"), form.width() / form.height()));
    m.push_back(metric(row_of(rows, "lower_upper_area_ratio"), form.lower_upper_ratio()));
    m.push_back(metric(row_of(rows, "centroid_shift_m"),
                       form.centroid().y() - center_of_mass_height(s.particles) - initial_offset_));
  } else {
    m.push_back(metric(row_of(rows, "contour_crossed_time_s"), crossed_time_));
  }
  m.push_back(metric(row_of(rows, "area_difference_m2"), area_difference_));
  if (topology_time_ >= 0) m.push_back(metric(row_of(rows, "topology_changed_time_s"), topology_time_));
  m.push_back(metric(row_of(rows, "final_void_area_m2"), history_.back().void_area));
  m.push_back(metric(row_of(rows, "new_cavities"), static_cast<double>(most_new_)));
  if (new_time_ >= 0) m.push_back(metric(row_of(rows, "new_cavities_time_s"), new_time_));
  m.push_back(metric(row_of(rows, "cavities_at_end"), static_cast<double>(void_.closed_regions())));
  jet_.finish(result);
  if (closed_time_ >= 0) m.push_back(metric(row_of(rows, "cavity_closed_time_s"), closed_time_));
  if (joined_time_ >= 0) m.push_back(metric(row_of(rows, "cavity_joined_outside_time_s"), joined_time_));
  result.area_history = history_;
}

template <int axes>
void BasicCavity<axes>::carry(Archive& a) {
  Archive contour = a.part("contour"), empty = a.part("void"), jet = a.part("jet");
  outline_.carry(contour), void_.carry(empty), jet_.carry(jet);
  a.numbers("history", history_);
  a.numbers("sizes", sizes_);
  a.number("smallest_size", smallest_size_), a.number("smallest_difference", smallest_difference_);
  a.number("smallest_sample", smallest_sample_);
  a.integer("most_new", most_new_), a.number("new_time", new_time_);
  a.number("closed_time", closed_time_), a.number("joined_time", joined_time_);
  a.number("crossed_time", crossed_time_), a.number("topology_time", topology_time_);
  a.number("area_difference", area_difference_);
}

template class BasicCavity<2>;
template class BasicCavity<3>;

}  // namespace mpm
